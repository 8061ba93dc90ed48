// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QSlider>

namespace hepatica {
namespace {

QWidget* as_field(QObject* watched) {
    const bool field = qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                       qobject_cast<QComboBox*>(watched) != nullptr ||
                       qobject_cast<QSlider*>(watched) != nullptr;
    return field ? static_cast<QWidget*>(watched) : nullptr;
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
    QWidget* field = as_field(watched);
    if (field == nullptr) return false;
    if (event->type() == QEvent::Polish) {
        // Otherwise the wheel would focus the field first.
        if (field->focusPolicy() == Qt::WheelFocus) field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (field->hasFocus()) return false;
    event->ignore();  // passed on to the parent
    return true;
}

}  // namespace hepatica
