// SPDX-License-Identifier: GPL-3.0-or-later
// Adds up what presses on a tool and drags it.
#pragma once

#include "core/deform/potentials/tool_pad.h"

namespace hepatica {

// Keeps a reference to the tool.
class ToolLoadSum {
  public:
    explicit ToolLoadSum(const Tool& tool) : tool_(tool), centre_mm_(tool.centre_mm()) {}

    // By `share` of its force.
    void press(const PadContact& contact, double share = 1.0);
    // By this force on what is touched there.
    void drag(const Vec3& at_mm, const Vec3& on_touched_un);

    // Force, torque, grip and their place; the rest is as in ToolLoad by default.
    ToolLoad load() const;

  private:
    const Tool& tool_;
    Vec3 centre_mm_;
    ToolLoad load_;  // `at_mm` times the force so far
    double pressed_un_ = 0.0;
};

}  // namespace hepatica
