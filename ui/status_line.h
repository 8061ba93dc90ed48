// SPDX-License-Identifier: GPL-3.0-or-later
// Figures at the window's foot: bleeding, step time, real-time factor, expected error, picture time
// and renderer. The caller updates them at most four times a second, so that they are readable. UI
// thread only.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "core/scene/frame.h"
#include "ui/flow_units.h"

class QLabel;
class QToolButton;

namespace hepatica {

class ElidedStatusBar;

class StatusLine {
  public:
    // What tells of the machine alone gives way to a message of the bar.
    explicit StatusLine(ElidedStatusBar& bar);

    // `recorded`: of a play that is looked back on.
    void show_statistics(const FrameStatistics& statistics, bool recorded = false);
    void show_picture_time(double ms);
    void show_renderer(const std::string& name);
    void clear_statistics();
    // Seen wherever the panels stand; nothing where nothing or hardly anything bleeds.
    void show_bleeding(const std::optional<TearView>& tear, FlowUnits units);
    // A red dot while a play is being recorded.
    void show_recording(bool recording);
    // How many warnings of the patient hold; a click on them is on_warnings().
    void show_warnings(std::size_t warnings);
    std::function<void()> on_warnings = [] {};

  private:
    QToolButton* warnings_;
    QLabel* recording_;
    QLabel* bleeding_;
    QLabel* step_;
    QLabel* real_time_;
    QLabel* error_;
    QLabel* picture_;
    QLabel* renderer_;
};

}  // namespace hepatica
