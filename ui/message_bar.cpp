// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_bar.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "ui/branch_links.h"
#include "ui/core_words.h"
#include "ui/patient_place.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

MessageBar::MessageBar(QWidget* pictures, Qt::Edge edge)
    : OverlayBar(edge, pictures),
      label_(new QLabel(this)),
      more_(new QToolButton(this)),
      first_{new QPushButton(this), {}},
      second_{new QPushButton(this), {}} {
    setObjectName("messageBar");
    label_->setTextFormat(Qt::RichText);  // plain text would show the escapes
    label_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(label_, &QLabel::linkActivated, this, [this](const QString& link) {
        const std::optional<int> branch = branch_of_link(link);
        if (branch && on_branch) on_branch(*branch);
    });
    label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    more_->setObjectName("moreOfMessage");
    connect(more_, &QToolButton::clicked, this, [this] { set_open(!open_); });
    first_.button->setObjectName("offer");
    second_.button->setObjectName("secondOffer");
    for (Offer* offer : {&first_, &second_})
        connect(offer->button, &QPushButton::clicked, this, [this, offer] {
            dismiss();
            // Taken out first: the action may show another notice, which replaces it.
            const std::function<void()> act = std::exchange(offer->act, {});
            act();
        });
    auto* close = new QToolButton(this);
    close->setText("✕");
    close->setAutoRaise(true);
    close->setAccessibleName(Words::tr("Dismiss"));
    close->setObjectName("closeMessage");
    connect(close, &QToolButton::clicked, this, [this] {
        dismiss();
        if (const std::function<void()> act = std::exchange(closed_, {})) act();
    });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 3, 6, 3);
    row->addWidget(label_, 1);
    for (QWidget* button :
         std::initializer_list<QWidget*>{more_, first_.button, second_.button, close})
        row->addWidget(button, 0, Qt::AlignVCenter);
}

QStringList lines_of(const Failure& failure) {
    QString problem = translated(failure.problem);
    if (!problem.isEmpty()) problem[0] = problem[0].toUpper();
    QStringList lines{problem};
    if (!failure.place.empty() && !names_its_place(failure))
        lines << (position_of(failure.place) ? Words::tr("at %1") : Words::tr("in %1"))
                     .arg(place_in_words(failure));
    if (!failure.remedy.empty()) lines << translated(failure.remedy);
    return lines;
}

void MessageBar::show_failure(const Failure& failure) {
    show_as("failure", lines_of(failure));
}

void MessageBar::show_notice(const QString& text) {
    show_as("notice", text.split("\n"));
}

void MessageBar::show_notice(const QString& text, const QString& button,
                             std::function<void()> act) {
    show_notice(text);
    offer(first_, button, std::move(act));
}

void MessageBar::put_before(const QString& text) {
    lines_ = text.split("\n") + lines_;
    write();
}

void MessageBar::offer_first(const QString& button, std::function<void()> act) {
    offer(first_, button, std::move(act));
}

void MessageBar::offer_also(const QString& button, std::function<void()> act) {
    offer(second_, button, std::move(act));
}

void MessageBar::offer(Offer& offer, const QString& button, std::function<void()> act) {
    offer.act = std::move(act);
    offer.button->setText(QString(button).replace("&", "&&"));  // names may hold one
    offer.button->show();
    write();  // the label has less room now
}

// Whatever of it is hidden now.
int MessageBar::height_of_line() {
    ensurePolished();  // margins are the theme's
    int height = label_->fontMetrics().height();
    for (int i = 0; i < layout()->count(); ++i)
        height = std::max(height, layout()->itemAt(i)->widget()->sizeHint().height());
    const QMargins around = layout()->contentsMargins() + contentsMargins();
    return height + around.top() + around.bottom();
}

QString MessageBar::text() const {
    return isHidden() ? QString() : lines_.join("\n");
}

void MessageBar::show_as(const char* kind, const QStringList& lines) {
    setProperty("kind", kind);
    style()->unpolish(this);
    style()->polish(this);
    lines_ = lines;
    strong_ = QString(kind) == "failure";
    open_ = false;
    closed_ = {};
    first_.button->hide();
    second_.button->hide();
    show();
    write();
}

void MessageBar::set_open(bool open) {
    open_ = open;
    write();
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    OverlayBar::resizeEvent(event);
    write();
}

// The width of a message set before the window was shown is known only now.
void MessageBar::showEvent(QShowEvent* event) {
    OverlayBar::showEvent(event);
    QMetaObject::invokeMethod(
        this, [this] { write(); }, Qt::QueuedConnection);
}

// The theme is another: links keep the colour that they were written with.
void MessageBar::changeEvent(QEvent* event) {
    OverlayBar::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !lines_.isEmpty()) write();
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    const bool acts = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel;
    if (acts && open_) set_open(false);
    return OverlayBar::eventFilter(watched, event);
}

// Writes the message in one line, elided if needed, or all of it if open.
void MessageBar::write() {
    const QString first = lines_.value(0);
    const auto strongly = [this](const QString& text) {
        return strong_ ? "<b>" + text.toHtmlEscaped() + "</b>" : text.toHtmlEscaped();
    };
    const QString one_line = lines_.join(strong_ ? " – " : "  ");
    QFont font = label_->font();
    font.setBold(strong_);
    const QMargins margins = layout()->contentsMargins();
    int room = width() - margins.left() - margins.right();
    for (int i = 1; i < layout()->count(); ++i)
        if (QWidget* beside = layout()->itemAt(i)->widget(); beside != more_ && !beside->isHidden())
            room -= beside->sizeHint().width() + layout()->spacing();
    const QFontMetrics metrics(font);
    const bool fits =
        lines_.size() == 1 || !open_ ? metrics.horizontalAdvance(one_line) <= room : false;
    more_->setText(open_ ? Words::tr("Less") : Words::tr("More"));
    more_->setVisible(!fits);
    label_->setToolTip(fits ? QString() : lines_.join("\n").toHtmlEscaped().replace("\n", "<br>"));
    if (fits) open_ = false;
    label_->setWordWrap(open_);
    const QColor link = QGuiApplication::palette().color(QPalette::Link);
    if (open_) {
        QStringList rest;
        for (const QString& line : lines_.mid(1)) rest << line.toHtmlEscaped();
        label_->setText(
            with_branch_links((QStringList(strongly(first)) + rest).join("<br>"), link));
    } else {
        if (!fits) room -= more_->sizeHint().width() + layout()->spacing();
        const QString shown = metrics.elidedText(one_line, Qt::ElideRight, room);
        const qsizetype strong = shown.startsWith(first) ? first.size() : shown.size();
        label_->setText(with_branch_links(
            strongly(shown.left(strong)) + shown.mid(strong).toHtmlEscaped(), link));
    }
    layout()->activate();
    lie_on_edge();
}

}  // namespace hepatica
