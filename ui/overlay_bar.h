// SPDX-License-Identifier: GPL-3.0-or-later
// A bar along an edge of its parent, on top of its content, so that no picture moves when the bar
// appears, grows or goes, even while the user drags. `on_cover` tells what to keep clear: text over
// the pictures, and where nothing is dragged, as in the library, the content itself.
#pragma once

#include <QFrame>
#include <functional>

namespace hepatica {

// UI thread only.
class OverlayBar : public QFrame {
  public:
    // At the top or bottom edge; hidden at first.
    OverlayBar(Qt::Edge edge, QWidget* parent);

    // Height of the parent's covered part, in points; 0 while hidden.
    int covered() const { return isHidden() ? 0 : height(); }
    // Called when covered() changes.
    std::function<void()> on_cover;

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    // To be called after the height of the content has changed.
    void lie_on_edge();

  private:
    void tell_what_is_covered();

    Qt::Edge edge_;
    int told_ = 0;
};

}  // namespace hepatica
