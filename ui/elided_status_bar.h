// SPDX-License-Identifier: GPL-3.0-or-later
// A status bar whose message comes before the figures that give way to it, and ends in an ellipsis
// where those that stay leave too little room; the tooltip shows the whole message then.
#pragma once

#include <QStatusBar>
#include <vector>

namespace hepatica {

class ElidedStatusBar : public QStatusBar {
  public:
    explicit ElidedStatusBar(QWidget* parent = nullptr);

    // These figures of the bar hide, the last one first, while a message needs their room. Added
    // before the others, they leave those where they are.
    void set_giving_way(std::vector<QWidget*> figures);
    QString shown() const;  // the message as it is drawn now

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

    void resizeEvent(QResizeEvent* event) override;

  private:
    QRect room_for_message() const;
    // Whether figures that have room again may come back, or wait for the next message or size.
    void make_room(bool may_come_back);

    std::vector<QWidget*> giving_way_;
};

}  // namespace hepatica
