// SPDX-License-Identifier: GPL-3.0-or-later
// Number field that shows the decimal sign of the window's language and accepts comma and point
// alike.
#pragma once

#include <QDoubleSpinBox>

namespace hepatica {

// UI thread only.
class DecimalSpinBox : public QDoubleSpinBox {
  public:
    // `unit` is shown after the number. valueChanged() is emitted when editing ends, not per key.
    DecimalSpinBox(double lower, double upper, double value, int decimals, const QString& unit,
                   QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;

  protected:
    // Beside the view, Enter ends the editing: keys pressed afterwards are those of the tools.
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QString with_sign(QString text) const;
};

}  // namespace hepatica
