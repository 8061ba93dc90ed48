// SPDX-License-Identifier: GPL-3.0-or-later
// The line above the view that says what went wrong, where, and what to do; it stays until it is
// dismissed or replaced, and never stands in the way.
#pragma once

#include <QFrame>

#include "ui/background_job.h"

class QLabel;

namespace hepatica {

class MessageBar : public QFrame {
  public:
    explicit MessageBar(QWidget* parent = nullptr);

    void show_failure(const Failure& failure);
    void show_notice(const QString& text);
    void dismiss() { hide(); }
    QString text() const;  // plain, of what is shown; empty while hidden

  private:
    void show_as(const char* kind, const QString& html);

    QLabel* label_;
};

}  // namespace hepatica
