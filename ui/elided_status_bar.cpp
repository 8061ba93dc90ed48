// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/elided_status_bar.h"

#include <QHelpEvent>
#include <QLayout>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "ui/plain_text.h"

namespace hepatica {

namespace {

constexpr int message_margin = 6;

}  // namespace

ElidedStatusBar::ElidedStatusBar(QWidget* parent) : QStatusBar(parent) {
    connect(this, &QStatusBar::messageChanged, this, [this] { make_room(true); });
}

void ElidedStatusBar::set_giving_way(std::vector<QWidget*> figures) {
    giving_way_ = std::move(figures);
    make_room(true);
}

void ElidedStatusBar::make_room(bool may_come_back) {
    const int spacing = layout() != nullptr ? std::max(0, layout()->spacing()) : 0;
    const auto width_of = [spacing](const QWidget& figure) {
        return figure.sizeHint().width() + spacing;
    };
    int room = width() - 2 * message_margin - fontMetrics().horizontalAdvance(currentMessage());
    for (const QWidget* beside : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (!beside->isHidden() && std::ranges::find(giving_way_, beside) == giving_way_.end())
            room -= width_of(*beside);
    for (QWidget* figure : giving_way_) {
        room -= width_of(*figure);
        const bool has_room = currentMessage().isEmpty() || room >= 0;
        if (!has_room || may_come_back) figure->setVisible(has_room);
    }
}

void ElidedStatusBar::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    make_room(true);
}

// What is shown beside the message stands at the right.
QRect ElidedStatusBar::room_for_message() const {
    int right = width();
    for (const QWidget* beside : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (beside->isVisible()) right = std::min(right, beside->x());
    return {message_margin, 0, std::max(0, right - 2 * message_margin), height()};
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
    // A figure has changed, which happens several times a second: none comes and goes with it.
    if (event->type() == QEvent::LayoutRequest) make_room(false);
    if (event->type() != QEvent::ToolTip) return QStatusBar::event(event);
    const bool cut = shown() != currentMessage();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       cut ? as_plain(currentMessage()) : QString(), this);
    return true;
}

}  // namespace hepatica
