// SPDX-License-Identifier: GPL-3.0-or-later
// The line over the top of the pictures that says what went wrong, where, and what to do; it stays
// until it is dismissed or replaced, and moves nothing. What does not fit in one line opens on
// demand, so that no vessel is hidden behind words. Where something can be done at once, it has a
// button for it.
#pragma once

#include <QStringList>
#include <functional>

#include "ui/background_job.h"
#include "ui/overlay_bar.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace hepatica {

// What went wrong, where, and what helps, each as far as it is known.
QStringList lines_of(const Failure& failure);

class MessageBar : public OverlayBar {
  public:
    explicit MessageBar(QWidget* pictures);

    void show_failure(const Failure& failure);
    void show_notice(const QString& text);
    // With a button of this name that does `act` and dismisses the message.
    void show_notice(const QString& text, const QString& button, std::function<void()> act);
    // One more button of the notice that is shown.
    void offer_also(const QString& button, std::function<void()> act);
    // A branch, from 0, whose name in the message was clicked.
    std::function<void(int branch)> on_branch;
    void dismiss() { hide(); }
    QString text() const;                // plain, all of it, a paragraph a line; empty while hidden
    bool open() const { return open_; }  // all of it is to be seen
    // All of it covers what lies under it: one line is left as soon as somebody acts in there.
    void fold_when_used(QWidget& picture) { picture.installEventFilter(this); }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    // The first line is written more strongly where it is a failure's.
    void show_as(const char* kind, const QStringList& lines);
    void set_open(bool open);
    void write();

    QStringList lines_;
    bool strong_ = false;
    bool open_ = false;
    QLabel* label_;
    QToolButton* more_;
    struct Offer {
        QPushButton* button;
        std::function<void()> act;
    };
    void offer(Offer& offer, const QString& button, std::function<void()> act);

    Offer first_, second_;
};

}  // namespace hepatica
