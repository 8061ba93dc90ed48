// SPDX-License-Identifier: GPL-3.0-or-later
// A status bar whose message ends in an ellipsis where the figures beside it leave too little room;
// the tooltip shows the whole message then.
#pragma once

#include <QStatusBar>

namespace hepatica {

class ElidedStatusBar : public QStatusBar {
  public:
    using QStatusBar::QStatusBar;

    QString shown() const;  // the message as it is drawn now

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QRect room_for_message() const;
};

}  // namespace hepatica
