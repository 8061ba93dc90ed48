// SPDX-License-Identifier: GPL-3.0-or-later
// A bar along an edge of its parent, over what the parent shows: nothing there moves when the bar
// comes, grows or goes, which may be while somebody draws.
#pragma once

#include <QFrame>

namespace hepatica {

class OverlayBar : public QFrame {
  public:
    // At the top or the bottom edge; hidden at first.
    OverlayBar(Qt::Edge edge, QWidget* parent);

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    // After what it shows has become higher or lower.
    void lie_on_edge();

  private:
    Qt::Edge edge_;
};

}  // namespace hepatica
