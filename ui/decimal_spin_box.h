// SPDX-License-Identifier: GPL-3.0-or-later
// A number field that takes a decimal comma and a decimal point alike, whatever the locale says.
#pragma once

#include <QDoubleSpinBox>

namespace hepatica {

class DecimalSpinBox : public QDoubleSpinBox {
  public:
    DecimalSpinBox(double lower, double upper, double value, int decimals, const QString& unit,
                   QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
};

}  // namespace hepatica
