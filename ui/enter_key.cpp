// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/enter_key.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>

namespace hepatica {
namespace {

void press(QAbstractButton& button) {
    auto* tool = qobject_cast<QToolButton*>(&button);
    if (tool != nullptr && tool->popupMode() == QToolButton::InstantPopup)
        tool->showMenu();
    else
        button.click();
}

}  // namespace

EnterKey::EnterKey(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool EnterKey::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return false;
    const bool is_button = qobject_cast<QPushButton*>(watched) != nullptr ||
                           qobject_cast<QToolButton*>(watched) != nullptr;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool is_enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (!is_button || !is_enter || (key->modifiers() & ~Qt::KeypadModifier) != 0) return false;
    // A key that is held down presses once.
    if (!key->isAutoRepeat()) press(*static_cast<QAbstractButton*>(watched));
    return true;
}

}  // namespace hepatica
