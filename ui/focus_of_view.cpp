// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/focus_of_view.h"

#include <QApplication>
#include <QWidget>

namespace hepatica {

void give_focus_back_to(QWidget& view) {
    QObject::connect(qApp, &QApplication::focusChanged, &view,
                     [&view](const QWidget* before, const QWidget* now) {
                         if (before == nullptr || now == nullptr || now == &view) return;
                         const QWidget* window = view.window();
                         if (before->window() != window || now->window() != window) return;
                         if (!before->isEnabled() || !before->isVisible()) view.setFocus();
                     });
}

}  // namespace hepatica
