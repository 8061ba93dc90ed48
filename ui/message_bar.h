// SPDX-License-Identifier: GPL-3.0-or-later
// Bar over an edge of the pictures for failures and notices: what, where, and what to do. It stays
// until dismissed or replaced. A message longer than a line opens on demand, so that no vessel is
// covered; buttons offer what can be done at once.
#pragma once

#include <QStringList>
#include <functional>
#include <utility>

#include "ui/background_job.h"
#include "ui/overlay_bar.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace hepatica {

// Problem, place and remedy, as far as they are known.
QStringList lines_of(const Failure& failure);

// UI thread only.
class MessageBar : public OverlayBar {
  public:
    explicit MessageBar(QWidget* pictures, Qt::Edge edge = Qt::TopEdge);

    void show_failure(const Failure& failure);
    void show_notice(const QString& text);
    // With a button of this name that calls `act` and dismisses the message.
    void show_notice(const QString& text, const QString& button, std::function<void()> act);
    // Puts these lines before those of the notice that is shown, which keeps its buttons.
    void put_before(const QString& text);
    // Adds a button to what is shown, a notice without one or a failure.
    void offer_first(const QString& button, std::function<void()> act);
    // Adds a second button to the notice that is shown.
    void offer_also(const QString& button, std::function<void()> act);
    // Called when the notice that is shown is closed by its ×.
    void when_closed(std::function<void()> act) { closed_ = std::move(act); }
    // Called with the index of a branch whose name in the message was clicked.
    std::function<void(int branch)> on_branch;
    void dismiss() { hide(); }
    QString text() const;  // plain, one paragraph per line; empty while hidden
    // Of a message in one line beside buttons, in points.
    int height_of_line();
    bool open() const { return open_; }  // the whole text is visible
    // An open message is folded to one line when the user clicks or scrolls in `picture`.
    void fold_when_used(QWidget& picture) { picture.installEventFilter(this); }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    // The first line of a failure is bold.
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
    std::function<void()> closed_;
};

}  // namespace hepatica
