// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/decimal_spin_box.h"

namespace hepatica {

DecimalSpinBox::DecimalSpinBox(double lower, double upper, double value, int decimals,
                               const QString& unit, QWidget* parent)
    : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setDecimals(decimals);
    setRange(lower, upper);
    setValue(value);
    if (!unit.isEmpty()) setSuffix(" " + unit);
    setKeyboardTracking(false);
}

QValidator::State DecimalSpinBox::validate(QString& text, int& position) const {
    text.replace(',', '.');
    return QDoubleSpinBox::validate(text, position);
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    QString with_point = text;
    return QDoubleSpinBox::valueFromText(with_point.replace(',', '.'));
}

}  // namespace hepatica
