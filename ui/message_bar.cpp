// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <utility>

#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {

MessageBar::MessageBar(QWidget* pictures)
    : OverlayBar(Qt::TopEdge, pictures),
      label_(new QLabel(this)),
      first_{new QPushButton(this), {}},
      second_{new QPushButton(this), {}} {
    setObjectName("messageBar");
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::RichText);  // else a text without a tag would show its escapes
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    first_.button->setObjectName("offer");
    second_.button->setObjectName("secondOffer");
    for (Offer* offer : {&first_, &second_})
        connect(offer->button, &QPushButton::clicked, this, [this, offer] {
            dismiss();
            offer->act();
        });
    auto* close = new QToolButton(this);
    close->setText("✕");
    close->setAutoRaise(true);
    close->setAccessibleName(Words::tr("Dismiss"));
    connect(close, &QToolButton::clicked, this, [this] { dismiss(); });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 8, 8, 8);
    row->addWidget(label_, 1);
    row->addWidget(first_.button, 0, Qt::AlignTop);
    row->addWidget(second_.button, 0, Qt::AlignTop);
    row->addWidget(close, 0, Qt::AlignTop);
}

void MessageBar::show_failure(const Failure& failure) {
    const auto escaped = [](const std::string& text) { return translated(text).toHtmlEscaped(); };
    QString problem = translated(failure.problem);
    if (!problem.isEmpty()) problem[0] = problem[0].toUpper();
    QString html = "<b>" + problem.toHtmlEscaped() + "</b>";
    if (!failure.place.empty()) html += "<br>" + Words::tr("in %1").arg(escaped(failure.place));
    if (!failure.remedy.empty()) html += "<br>" + escaped(failure.remedy);
    show_as("failure", html);
}

void MessageBar::show_notice(const QString& text) {
    show_as("notice", text.toHtmlEscaped().replace("\n", "<br>"));
}

void MessageBar::show_notice(const QString& text, const QString& button,
                             std::function<void()> act) {
    show_notice(text);
    offer(first_, button, std::move(act));
}

void MessageBar::offer_also(const QString& button, std::function<void()> act) {
    offer(second_, button, std::move(act));
}

void MessageBar::offer(Offer& offer, const QString& button, std::function<void()> act) {
    offer.act = std::move(act);
    offer.button->setText(button);
    offer.button->show();
}

QString MessageBar::text() const {
    return isHidden() ? QString() : QTextDocumentFragment::fromHtml(label_->text()).toPlainText();
}

void MessageBar::show_as(const char* kind, const QString& html) {
    setProperty("kind", kind);
    style()->unpolish(this);
    style()->polish(this);
    label_->setText(html);
    first_.button->hide();
    second_.button->hide();
    show();
}

}  // namespace hepatica
