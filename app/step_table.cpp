// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_table.h"

#include <algorithm>

namespace hepatica {

StepTable::StepTable() {
    lines_ << "step,wall_ms,processor_ms,newton_iterations,solves,iterations,joints_parted,"
              "joints_broken,vertices_split,asleep,degraded,message\n";
}

void StepTable::add(const SessionStep& step, const FrameTime& took) {
    const StepReport& did = step.deform;
    std::string message = did.message;
    std::ranges::replace(message, '"', '\'');
    std::ranges::replace(message, '\n', ' ');
    lines_ << step.step << ',' << took.wall_ms << ',' << took.processor_ms << ','
           << did.newton_iterations << ',' << did.linear_solves << ',' << did.linear_iterations
           << ',' << did.tear.joints_parted << ',' << did.tear.joints_broken << ','
           << did.tear.vertices_split << ',' << (did.asleep ? 1 : 0) << ','
           << (did.degraded ? 1 : 0) << ",\"" << message << "\"\n";
}

}  // namespace hepatica
