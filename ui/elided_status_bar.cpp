// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/elided_status_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QToolTip>
#include <algorithm>

#include "ui/plain_text.h"

namespace hepatica {

// What is shown beside the message stands at the right.
QRect ElidedStatusBar::room_for_message() const {
    constexpr int margin = 6;
    int right = width();
    for (const QWidget* beside : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (beside->isVisible()) right = std::min(right, beside->x());
    return {margin, 0, std::max(0, right - 2 * margin), height()};
}

QString ElidedStatusBar::shown() const {
    return fontMetrics().elidedText(currentMessage(), Qt::ElideRight, room_for_message().width());
}

// QStatusBar would cut the message off within a letter.
void ElidedStatusBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    painter.setPen(palette().windowText().color());
    painter.drawText(room_for_message(), Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                     shown());
}

bool ElidedStatusBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QStatusBar::event(event);
    const bool cut = shown() != currentMessage();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       cut ? as_plain(currentMessage()) : QString(), this);
    return true;
}

}  // namespace hepatica
