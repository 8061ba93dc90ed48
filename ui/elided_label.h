// SPDX-License-Identifier: GPL-3.0-or-later
// A line of text in a place that may be too narrow for it: what does not fit is left out where one
// says, with dots in its place, and all of it is in the tooltip. It never makes its window wider.
#pragma once

#include <QLabel>

namespace hepatica {

class ElidedLabel : public QLabel {
  public:
    ElidedLabel(Qt::TextElideMode mode, QWidget* parent) : QLabel(parent), mode_(mode) {
        setTextFormat(Qt::PlainText);
    }

    QString shown() const;  // as it is drawn now
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    Qt::TextElideMode mode_;
};

}  // namespace hepatica
