// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/on_screen.h"

#include <QHeaderView>
#include <QLayout>
#include <QScreen>
#include <QStyle>
#include <QTableView>
#include <QWidget>
#include <algorithm>

namespace hepatica {

void resize_on_screen(QWidget& window, const QSize& wanted) {
    // The title bar, added by the desktop, would push the window's foot off the screen.
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
    window.resize(wanted.boundedTo(window.screen()->availableSize() - QSize(0, title)));
}

void widen_to_columns(QWidget& dialog, const QTableView& table) {
    const QMargins around = dialog.layout()->contentsMargins();
    const int needed = table.horizontalHeader()->length() + 2 * table.frameWidth() +
                       dialog.style()->pixelMetric(QStyle::PM_ScrollBarExtent) + around.left() +
                       around.right();
    if (needed > dialog.width()) resize_on_screen(dialog, {needed, dialog.height()});
}

QRect unframed_place(const QWidget& window) {
    const bool fills = window.isMaximized() || window.isFullScreen();
    return !fills && window.frameGeometry() == window.geometry() ? window.geometry() : QRect();
}

void restore_unframed(QWidget& window, const QRect& unframed) {
    if (unframed.isValid() && window.screen()->availableGeometry().contains(unframed))
        window.setGeometry(unframed);
}

void place_on_screen(QWidget& window, const QPoint& wanted, int title) {
    const QRect room = window.screen()->availableGeometry().adjusted(0, title, 0, 0);
    window.resize(window.size().boundedTo(room.size()));
    // The content may need more room, which is known only after layout.
    if (window.layout() != nullptr) window.layout()->activate();
    const auto nearest = [](int place, int low, int high) {
        return std::max(low, std::min(place, high));
    };
    // Without its frame, which the desktop adds some time after the first show: move() would place
    // the content then, and the frame from the second time on.
    window.setGeometry({{nearest(wanted.x(), room.left(), room.right() + 1 - window.width()),
                         nearest(wanted.y(), room.top(), room.bottom() + 1 - window.height())},
                        window.size()});
}

}  // namespace hepatica
