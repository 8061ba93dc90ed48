// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overlay_bar.h"

#include <QEvent>
#include <algorithm>
#include <utility>

namespace hepatica {

OverlayBar::OverlayBar(Qt::Edge edge, QWidget* parent) : QFrame(parent), edge_(edge) {
    parent->installEventFilter(this);
    hide();
}

// As wide as the parent, and as high as the content then needs.
void OverlayBar::lie_on_edge() {
    const QSize room = parentWidget()->size();
    const int needed = hasHeightForWidth() ? heightForWidth(room.width()) : sizeHint().height();
    const int height = std::min(needed, room.height());
    setGeometry(0, edge_ == Qt::TopEdge ? 0 : room.height() - height, room.width(), height);
    tell_what_is_covered();
}

void OverlayBar::tell_what_is_covered() {
    if (std::exchange(told_, covered()) != covered() && on_cover) on_cover();
}

bool OverlayBar::event(QEvent* event) {
    const bool done = QFrame::event(event);
    if (event->type() == QEvent::Show) raise();
    if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest) lie_on_edge();
    if (event->type() == QEvent::Hide) tell_what_is_covered();
    return done;
}

bool OverlayBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) lie_on_edge();
    return QFrame::eventFilter(watched, event);
}

}  // namespace hepatica
