// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and places of windows within their screen: not everywhere is there a window manager that
// would see to it.
#pragma once

#include <QPoint>
#include <QSize>

class QWidget;

namespace hepatica {

// As large as wanted, where the screen has room for it.
void resize_on_screen(QWidget& window, const QSize& wanted);
// A window that is shown: where it is wanted, or as near as it is wholly on its screen, `title`
// below the upper edge; smaller where it does not fit, as far as what is in it allows.
void place_on_screen(QWidget& window, const QPoint& wanted, int title);

}  // namespace hepatica
