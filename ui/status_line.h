// SPDX-License-Identifier: GPL-3.0-or-later
// Figures at the window's foot: step time, real-time factor, expected error, picture time and
// renderer. The caller updates them at most four times a second, so that they are readable. UI
// thread only.
#pragma once

#include <QStatusBar>

#include "core/scene/frame.h"

class QLabel;

namespace hepatica {

class StatusLine {
  public:
    explicit StatusLine(QStatusBar& bar);

    void show_statistics(const FrameStatistics& statistics);
    void show_picture_time(double ms);
    void show_renderer(const std::string& name);
    void clear_statistics();
    // A red dot while a play is being recorded.
    void show_recording(bool recording);

  private:
    QLabel* recording_;
    QLabel* step_;
    QLabel* real_time_;
    QLabel* error_;
    QLabel* picture_;
    QLabel* renderer_;
};

}  // namespace hepatica
