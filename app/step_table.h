// SPDX-License-Identifier: GPL-3.0-or-later
// A table of comma-separated values with one line for each step of a play: its cost and its work.
#pragma once

#include <sstream>
#include <string>

#include "core/session/session.h"
#include "core/study/timing.h"

namespace hepatica {

class StepTable {
  public:
    StepTable();
    void add(const SessionStep& step, const FrameTime& took);
    std::string text() const { return lines_.str(); }

  private:
    std::ostringstream lines_;
};

}  // namespace hepatica
