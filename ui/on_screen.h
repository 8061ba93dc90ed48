// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps windows within their screen, because not every system has a window manager that does.
#pragma once

#include <QPoint>
#include <QSize>

class QWidget;

namespace hepatica {

// Resizes a window to the wanted size, limited to its screen.
void resize_on_screen(QWidget& window, const QSize& wanted);
// Moves the content of a shown window to the wanted place, or the nearest one at which it is
// entirely on its screen and `title`, the height of a title bar, below the upper edge. Shrinks it
// if needed, as far as its content allows.
void place_on_screen(QWidget& window, const QPoint& wanted, int title);

}  // namespace hepatica
