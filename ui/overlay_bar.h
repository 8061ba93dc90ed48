// SPDX-License-Identifier: GPL-3.0-or-later
// A bar along an edge of its parent, over what the parent shows: no picture there moves when the
// bar comes, grows or goes, which may be while somebody draws. Whoever writes words into the
// pictures is told, and keeps them clear of it.
#pragma once

#include <QFrame>
#include <functional>

namespace hepatica {

class OverlayBar : public QFrame {
  public:
    // At the top or the bottom edge; hidden at first.
    OverlayBar(Qt::Edge edge, QWidget* parent);

    // Of the parent, from its edge, in points; 0 while the bar is hidden.
    int covered() const { return isHidden() ? 0 : height(); }
    // Whenever that is another.
    std::function<void()> on_cover;

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    // After what it shows has become higher or lower.
    void lie_on_edge();

  private:
    void tell_what_is_covered();

    Qt::Edge edge_;
    int told_ = 0;
};

}  // namespace hepatica
