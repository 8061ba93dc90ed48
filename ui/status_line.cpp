// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/status_line.h"

#include <QLabel>

#include "ui/quality_panel.h"

namespace hepatica {

StatusLine::StatusLine(QStatusBar& bar)
    : step_(new QLabel(&bar)),
      real_time_(new QLabel(&bar)),
      error_(new QLabel(&bar)),
      picture_(new QLabel(&bar)),
      renderer_(new QLabel(&bar)) {
    step_->setObjectName("step");
    error_->setObjectName("expectedError");
    step_->setToolTip("Wall time of one step of the simulation");
    real_time_->setToolTip("Simulated time over wall time: 1 is real time, less is slower");
    picture_->setToolTip("Time of the last picture, until it was on the screen");
    renderer_->setToolTip("The OpenGL renderer");
    for (QLabel* label : {step_, real_time_, error_, picture_, renderer_}) {
        label->setContentsMargins(8, 0, 8, 0);
        bar.addPermanentWidget(label);
    }
}

void StatusLine::show_statistics(const FrameStatistics& statistics) {
    step_->setText(QString("step %1 ms").arg(statistics.step_ms, 0, 'f', 1));
    real_time_->setText(
        statistics.paused ? QString("held")
        : statistics.resting
            ? QString("at rest")
            : QString("real time × %1").arg(statistics.real_time_factor, 0, 'f', 2));
    QString error;
    if (statistics.expected_error > 0.0) {
        error = "expected error " + percent_text(statistics.expected_error);
        error_->setToolTip("Of the present setting of the dial, measured against " +
                           QString::fromStdString(statistics.error_reference));
    }
    error_->setText(error);
    error_->setVisible(!error.isEmpty());
}

void StatusLine::show_picture_time(double ms) {
    picture_->setText(QString("picture %1 ms").arg(ms, 0, 'f', 0));
}

void StatusLine::show_renderer(const std::string& name) {
    renderer_->setText(QString::fromStdString(name));
}

void StatusLine::clear_statistics() {
    for (QLabel* label : {step_, real_time_, error_}) label->clear();
}

}  // namespace hepatica
