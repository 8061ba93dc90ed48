// SPDX-License-Identifier: GPL-3.0-or-later
// A line of text that never widens its window: what does not fit is replaced by an ellipsis, and
// the tooltip shows the whole text.
#pragma once

#include <QLabel>

namespace hepatica {

class ElidedLabel : public QLabel {
  public:
    ElidedLabel(Qt::TextElideMode mode, QWidget* parent) : QLabel(parent), mode_(mode) {
        setTextFormat(Qt::PlainText);
    }

    QString shown() const;  // the text as it is drawn now
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    Qt::TextElideMode mode_;
};

}  // namespace hepatica
