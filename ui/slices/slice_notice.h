// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the 3D view while there are no slices: why, with a button that chooses the
// CT, or how far the reading of the CT has come, with one that cancels it.
#pragma once

#include <QWidget>
#include <functional>

#include "core/base/job.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace hepatica {

// UI thread only.
class SliceNotice : public QWidget {
  public:
    struct Callbacks {
        std::function<void()> choose;  // the person wants to choose the CT
        std::function<void()> cancel;  // the reading
    };
    SliceNotice(Callbacks callbacks, QWidget* parent);

    void say(const QString& text, bool can_choose);
    // A reading has begun, of which nothing is known yet.
    void show_reading();
    void show_progress(const JobProgress& now);

  private:
    void show_reading_of(const QString& stage);

    QLabel* text_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QPushButton* choose_;
};

}  // namespace hepatica
