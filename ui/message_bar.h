// SPDX-License-Identifier: GPL-3.0-or-later
// The line over the top of the pictures that says what went wrong, where, and what to do; it stays
// until it is dismissed or replaced, and moves nothing. Where something can be done at once, it has
// a button for it.
#pragma once

#include <functional>

#include "ui/background_job.h"
#include "ui/overlay_bar.h"

class QLabel;
class QPushButton;

namespace hepatica {

class MessageBar : public OverlayBar {
  public:
    explicit MessageBar(QWidget* pictures);

    void show_failure(const Failure& failure);
    void show_notice(const QString& text);
    // With a button of this name that does `act` and dismisses the message.
    void show_notice(const QString& text, const QString& button, std::function<void()> act);
    // One more button of the notice that is shown.
    void offer_also(const QString& button, std::function<void()> act);
    void dismiss() { hide(); }
    QString text() const;  // plain, of what is shown; empty while hidden

  private:
    void show_as(const char* kind, const QString& html);

    QLabel* label_;
    struct Offer {
        QPushButton* button;
        std::function<void()> act;
    };
    void offer(Offer& offer, const QString& button, std::function<void()> act);

    Offer first_, second_;
};

}  // namespace hepatica
