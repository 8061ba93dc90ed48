// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/decimal_spin_box.h"

#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>

namespace hepatica {

DecimalSpinBox::DecimalSpinBox(double lower, double upper, double value, int decimals,
                               const QString& unit, QWidget* parent)
    : QDoubleSpinBox(parent) {
    QLocale numbers;
    // The group separator of one language is the decimal sign of another.
    numbers.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(numbers);
    setDecimals(decimals);
    setRange(lower, upper);
    setValue(value);
    if (!unit.isEmpty()) setSuffix(" " + unit);
    setKeyboardTracking(false);
}

void DecimalSpinBox::keyPressEvent(QKeyEvent* event) {
    QDoubleSpinBox::keyPressEvent(event);
    const bool ends = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool beside_view = qobject_cast<QMainWindow*>(window()) != nullptr ||
                             qobject_cast<QDockWidget*>(window()) != nullptr;  // a floating panel
    if (!ends || !beside_view) return;
    clearFocus();  // where no view takes it
    for (QWidget* at = parentWidget(); at != nullptr; at = at->parentWidget())
        if (const auto* main = qobject_cast<QMainWindow*>(at))
            if (auto* view = main->findChild<QWidget*>("view")) view->setFocus();
}

QString DecimalSpinBox::with_sign(QString text) const {
    const QString sign = locale().decimalPoint();
    return text.replace(',', sign).replace('.', sign);
}

QValidator::State DecimalSpinBox::validate(QString& text, int& position) const {
    text = with_sign(text);
    return QDoubleSpinBox::validate(text, position);
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    return QDoubleSpinBox::valueFromText(with_sign(text));
}

}  // namespace hepatica
