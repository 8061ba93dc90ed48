// SPDX-License-Identifier: GPL-3.0-or-later
// The line below the view while a job runs: its stage in words, how far it is, what waits
// behind it, and Cancel.
#pragma once

#include <QFrame>
#include <functional>

#include "core/base/job.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace hepatica {

class ProgressStrip : public QFrame {
  public:
    explicit ProgressStrip(std::function<void()> cancel, QWidget* parent = nullptr);

    void start(const QString& title);
    void show_waiting(int jobs);  // behind the one that runs
    void update_progress(const JobProgress& progress);
    void say_cancelling();
    void finish() { hide(); }

  private:
    QLabel* title_;
    QLabel* stage_;
    QLabel* waiting_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace hepatica
