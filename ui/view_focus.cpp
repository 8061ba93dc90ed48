// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view_focus.h"

#include <QPainter>
#include <utility>

namespace hepatica {

ViewFocus::ViewFocus(QWidget& view) : QWidget(&view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void ViewFocus::show_aim(const std::optional<QPointF>& aim, bool holds) {
    if (aim == aim_ && holds == holds_) return;
    aim_ = aim;
    holds_ = holds;
    update();
}

void ViewFocus::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QColor colour = palette().color(QPalette::Link);
    painter.setPen(QPen(colour, 2.0));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
    if (!aim_) return;
    // Dark below and bright above, visible on every vessel; closed if something is held.
    painter.setRenderHint(QPainter::Antialiasing);
    const double gap = holds_ ? 0.0 : 6.0;
    for (const auto& [ink, width] :
         {std::pair{QColor(Qt::black), 4.0}, std::pair{colour.lighter(170), 1.8}}) {
        painter.setPen(QPen(ink, width));
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*aim_ + gap * way, *aim_ + 14.0 * way);
        if (holds_) painter.drawEllipse(*aim_, 9.0, 9.0);
    }
}

}  // namespace hepatica
