// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse wheel changes number fields, combo boxes and sliders only if they have the focus;
// otherwise it scrolls the panel, so that nothing is changed by accident. UI thread only.
#pragma once

#include <QObject>

namespace hepatica {

// Filters the events of the whole program while it exists.
class WheelGuard : public QObject {
  public:
    explicit WheelGuard(QObject* parent);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hepatica
