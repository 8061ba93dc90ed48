// SPDX-License-Identifier: GPL-3.0-or-later
// Escape closes an open drop-down list and does nothing else. Qt before 6.5 closes the list but
// then also runs the window's shortcut of that key (QTBUG-108908). UI thread only.
#pragma once

#include <QObject>

namespace hepatica {

// Filters the events of the whole program while it exists.
class PopupGuard : public QObject {
  public:
    explicit PopupGuard(QObject* parent);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hepatica
