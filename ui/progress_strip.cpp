// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/progress_strip.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/core_words.h"
#include "ui/elided_label.h"
#include "ui/plain_text.h"
#include "ui/words.h"

namespace hepatica {

double share_of_job(const JobProgress& progress) {
    if (progress.stage_count <= 0 || progress.stage_number <= 0) return progress.fraction;
    const int stages = std::max(progress.stage_number, progress.stage_count);
    return (progress.stage_number - 1 + progress.fraction) / stages;
}

ProgressStrip::ProgressStrip(std::function<void()> cancel, QWidget* pictures)
    : OverlayBar(Qt::BottomEdge, pictures),
      // The beginning tells what is done, and the end of a name distinguishes it.
      title_(new ElidedLabel(Qt::ElideMiddle, this)),
      stage_(new ElidedLabel(Qt::ElideRight, this)),
      waiting_(new ElidedLabel(Qt::ElideRight, this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(Words::tr("Cancel"), this)) {
    setObjectName("progressStrip");
    title_->setObjectName("jobTitle");
    stage_->setObjectName("quiet");
    waiting_->setObjectName("quiet");
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setMaximumWidth(260);
    bar_->setMinimumWidth(40);
    waiting_->hide();
    connect(cancel_, &QPushButton::clicked, this, std::move(cancel));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 8, 10, 8);
    row->setSpacing(14);
    row->addWidget(title_);
    // Share the room that the title leaves: in a narrow view the bar yields, not the words.
    row->addWidget(stage_, 3);
    row->addWidget(waiting_);
    row->addWidget(bar_, 1);
    row->addWidget(cancel_);
}

void ProgressStrip::start(const QString& title) {
    title_->setText(title);
    stage_->clear();
    stage_->setMinimumWidth(0);
    bar_->setRange(0, 0);
    cancel_->setToolTip(as_plain(Words::tr("Cancels this alone: %1").arg(title)));
    cancel_->setEnabled(true);
    show();
}

void ProgressStrip::show_others(const QStringList& waiting, const QString& beside) {
    QStringList others;
    if (!beside.isEmpty()) others << Words::tr("at the same time: %1").arg(beside);
    if (!waiting.isEmpty()) others << Words::tr("then: %1").arg(waiting.join(", "));
    waiting_->setVisible(!others.isEmpty());  // else a gap would stand there
    waiting_->setText(others.join("; "));
}

void ProgressStrip::update_progress(const JobProgress& progress) {
    if (!cancel_->isEnabled()) return;
    // Not begun, so that nothing is known: the bar of start() stays, which moves.
    if (progress.stage_number == 0 && progress.fraction == 0.0) return;
    QString stage = translated(progress.stage);
    if (progress.stage_count > 0 && progress.stage_number > 0) {
        stage +=
            "  " + Words::tr("(%1 of %2)").arg(progress.stage_number).arg(progress.stage_count);
    }
    stage_->setText(stage);
    // A long title yields before the stage is cut to a word.
    stage_->setMinimumWidth(std::min(stage_->sizeHint().width(), 2 * width() / 5));
    bar_->setRange(0, 1000);
    bar_->setValue(static_cast<int>(1000.0 * share_of_job(progress)));
}

void ProgressStrip::say_cancelling() {
    stage_->setText(Words::tr("Cancelling…"));
    cancel_->setEnabled(false);
}

}  // namespace hepatica
