// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_notice.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/core_words.h"
#include "ui/progress_strip.h"
#include "ui/words.h"

namespace hepatica {

SliceNotice::SliceNotice(Callbacks callbacks, QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(Words::tr("Cancel"), this)),
      choose_(new QPushButton(Words::tr("Choose the CT…"), this)) {
    setObjectName("sliceNotice");
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setAlignment(Qt::AlignCenter);
    text_->setObjectName("quiet");
    bar_->setObjectName("readingCt");
    bar_->setAccessibleName(Words::tr("Reading the CT"));
    bar_->setTextVisible(false);
    bar_->setMaximumWidth(260);
    cancel_->setObjectName("cancelCt");
    choose_->setObjectName("chooseCt");
    connect(choose_, &QPushButton::clicked, this, std::move(callbacks.choose));
    connect(cancel_, &QPushButton::clicked, this, std::move(callbacks.cancel));
    auto* column = new QVBoxLayout(this);
    column->addStretch();
    column->addWidget(text_);
    for (QWidget* widget : std::initializer_list<QWidget*>{bar_, cancel_, choose_})
        column->addWidget(widget, 0, Qt::AlignHCenter);
    column->addStretch();
    say({}, true);
}

void SliceNotice::say(const QString& text, bool can_choose) {
    text_->setText(text);
    choose_->setVisible(can_choose);
    bar_->hide();
    cancel_->hide();
}

void SliceNotice::show_reading() {
    bar_->setRange(0, 0);
    show_reading_of(Words::tr("Reading the CT…"));
}

void SliceNotice::show_progress(const JobProgress& now) {
    if (now.stage.empty()) return;
    bar_->setRange(0, 1000);
    bar_->setValue(static_cast<int>(1000.0 * share_of_job(now)));
    show_reading_of(translated(now.stage) + "…");
}

void SliceNotice::show_reading_of(const QString& stage) {
    text_->setText(stage);
    choose_->hide();
    bar_->show();
    cancel_->show();
}

}  // namespace hepatica
