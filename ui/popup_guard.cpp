// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/popup_guard.h"

#include <QApplication>
#include <QKeyEvent>

namespace hepatica {

PopupGuard::PopupGuard(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool PopupGuard::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || QApplication::activePopupWidget() == nullptr)
        return false;
    // What is accepted is looked up as no shortcut; the list still sees the key.
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) event->accept();
    return false;
}

}  // namespace hepatica
