// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps windows within their screen, because not every system has a window manager that does.
#pragma once

#include <QPoint>
#include <QRect>
#include <QSize>

class QTableView;
class QWidget;

namespace hepatica {

// Resizes a window to the wanted size, limited to its screen.
void resize_on_screen(QWidget& window, const QSize& wanted);
// Widens a dialog to all columns of its table, as far as the screen has room.
void widen_to_columns(QWidget& dialog, const QTableView& table);
// Where a shown window lies that has no frame; invalid where it has one, or fills the screen.
QRect unframed_place(const QWidget& window);
// Makes a window lie where restoreGeometry() would leave room for a title bar that it never had,
// so that it would lie lower at the next start. No effect where `unframed`, see above, is not
// wholly on the screen.
void restore_unframed(QWidget& window, const QRect& unframed);
// Moves the content of a shown window to the wanted place, or the nearest one at which it is
// entirely on its screen and `title`, the height of a title bar, below the upper edge. Shrinks it
// if needed, as far as its content allows.
void place_on_screen(QWidget& window, const QPoint& wanted, int title);

}  // namespace hepatica
