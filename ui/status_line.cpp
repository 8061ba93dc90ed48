// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/status_line.h"

#include <QLabel>
#include <QToolButton>

#include "core/scene/measured_dial.h"
#include "ui/core_words.h"
#include "ui/elided_status_bar.h"
#include "ui/quality_panel.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString red_dot() {
    return QStringLiteral("<span style='color:#e5484d'>●</span> ");
}

}  // namespace

StatusLine::StatusLine(ElidedStatusBar& bar)
    : warnings_(new QToolButton(&bar)),
      recording_(new QLabel(&bar)),
      bleeding_(new QLabel(&bar)),
      step_(new QLabel(&bar)),
      real_time_(new QLabel(&bar)),
      error_(new QLabel(&bar)),
      picture_(new QLabel(&bar)),
      renderer_(new QLabel(&bar)) {
    recording_->setObjectName("recording");
    recording_->setTextFormat(Qt::RichText);
    recording_->setText(red_dot() + Words::tr("Recording"));
    recording_->setToolTip(Words::tr("The play is recorded; F5 ends that"));
    bleeding_->setObjectName("bleeding");
    bleeding_->setTextFormat(Qt::RichText);
    bleeding_->setToolTip(Words::tr("What torn vessels lose now; the panel Tool says the sum"));
    step_->setObjectName("step");
    real_time_->setObjectName("realTime");
    error_->setObjectName("expectedError");
    step_->setToolTip(Words::tr("Wall time of one step of the simulation"));
    real_time_->setToolTip(
        Words::tr("Simulated time over wall time: 1 is real time, less is slower"));
    picture_->setToolTip(Words::tr("Time of the last picture, until it was on the screen"));
    renderer_->setObjectName("renderer");
    renderer_->setToolTip(Words::tr("The OpenGL renderer"));
    warnings_->setObjectName("warnings");
    warnings_->setAutoRaise(true);
    warnings_->setToolTip(
        Words::tr("What is to be known of this patient's vessels: show it again"));
    QObject::connect(warnings_, &QToolButton::clicked, warnings_, [this] { on_warnings(); });
    warnings_->setMaximumHeight(step_->sizeHint().height());  // the bar is as high as without it
    // Those that give way stand first, so that the others stay where they are.
    for (QWidget* figure : std::initializer_list<QWidget*>{
             renderer_, picture_, warnings_, recording_, bleeding_, step_, real_time_, error_}) {
        if (figure != warnings_) figure->setContentsMargins(8, 0, 8, 0);
        bar.addPermanentWidget(figure);
    }
    warnings_->hide();
    recording_->hide();
    bleeding_->hide();
    bar.set_giving_way({picture_, renderer_});
}

void StatusLine::show_statistics(const FrameStatistics& statistics, bool recorded) {
    step_->setText(Words::tr("step %L1 ms").arg(statistics.step_ms, 0, 'f', 1));
    real_time_->setText(
        statistics.paused    ? Words::tr("held")
        : statistics.resting ? Words::tr("at rest")
        // How fast it was computed says nothing of how fast it is shown.
        : recorded ? Words::tr("recorded")
                   : Words::tr("real time × %L1").arg(statistics.real_time_factor, 0, 'f', 2));
    QString error;
    if (statistics.expected_error > 0.0 && is_of_own_body(statistics.error_reference)) {
        error = Words::tr("expected error %1").arg(percent_text(statistics.expected_error));
        error_->setToolTip(words_of_reference(statistics.error_reference));
    }
    error_->setText(error);
    error_->setVisible(!error.isEmpty());
}

void StatusLine::show_picture_time(double ms) {
    picture_->setText(Words::tr("picture %1 ms").arg(ms, 0, 'f', 0));
}

void StatusLine::show_renderer(const std::string& name) {
    renderer_->setText(QString::fromStdString(name));
}

void StatusLine::clear_statistics() {
    for (QLabel* label : {step_, real_time_, error_}) label->clear();
    bleeding_->hide();
}

void StatusLine::show_bleeding(const std::optional<TearView>& tear, FlowUnits units) {
    // Not what would be shown as 0.
    const bool bleeds = tear && leak_text(tear->leak_g_s, units) != leak_text(0.0, units);
    bleeding_->setVisible(bleeds);
    if (bleeds)
        bleeding_->setText(red_dot() +
                           Words::tr("bleeds %1").arg(leak_text(tear->leak_g_s, units)));
}

void StatusLine::show_warnings(std::size_t warnings) {
    warnings_->setText(Words::tr("%n warning(s)", nullptr, static_cast<int>(warnings)));
    warnings_->setVisible(warnings > 0);
}

void StatusLine::show_recording(bool recording) {
    recording_->setVisible(recording);
}

}  // namespace hepatica
