// SPDX-License-Identifier: GPL-3.0-or-later
// Enter presses the button that has the focus, in every window: Qt does so in dialogs alone, and
// there not for every button. UI thread only.
#pragma once

#include <QObject>

namespace hepatica {

// Filters the events of the whole program while it exists. Boxes to tick are left out: in a dialog
// Enter means its default button there.
class EnterKey : public QObject {
  public:
    explicit EnterKey(QObject* parent);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hepatica
