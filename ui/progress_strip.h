// SPDX-License-Identifier: GPL-3.0-or-later
// Bar over the foot of the pictures while a job runs: stage, progress, the other jobs by name, and
// Cancel.
#pragma once

#include <QStringList>
#include <functional>

#include "core/base/job.h"
#include "ui/overlay_bar.h"

class QProgressBar;
class QPushButton;

namespace hepatica {

class ElidedLabel;

// Of the whole job where its stages are announced, each as long as another; else of the stage. In
// [0, 1].
double share_of_job(const JobProgress& progress);

// UI thread only.
class ProgressStrip : public OverlayBar {
  public:
    ProgressStrip(std::function<void()> cancel, QWidget* pictures);

    void start(const QString& title);
    // `waiting`: titles of those behind the shown one; `beside`: of one that runs beside it, or
    // none.
    void show_others(const QStringList& waiting, const QString& beside);
    void update_progress(const JobProgress& progress);
    void say_cancelling();
    void finish() { hide(); }

  private:
    ElidedLabel* title_;
    ElidedLabel* stage_;
    ElidedLabel* waiting_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace hepatica
