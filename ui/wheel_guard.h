// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse wheel changes a number, a choice or a slider only where that has the focus; over all
// others it scrolls the panel that they stand in, and nothing is changed unnoticed.
#pragma once

#include <QObject>

namespace hepatica {

// Filters the events of the whole program for as long as it lives.
class WheelGuard : public QObject {
  public:
    explicit WheelGuard(QObject* parent);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hepatica
