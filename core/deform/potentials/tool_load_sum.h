// SPDX-License-Identifier: GPL-3.0-or-later
// Sums the normal and friction forces on a tool.
#pragma once

#include <vector>

#include "core/deform/potentials/tool_pad.h"

namespace hepatica {

// Keeps a reference to the tool.
class ToolLoadSum {
  public:
    explicit ToolLoadSum(const Tool& tool)
        : tool_(tool), centre_mm_(tool.centre_mm()), pressed_open_un_(tool.parts.size(), 0.0) {}

    // Adds `share` of the contact's normal force.
    void press(const PadContact& contact, double share = 1.0);
    // Adds the reaction to a friction force on the body at this point.
    void drag(const Vec3& at_mm, const Vec3& on_touched_un);

    // Force, torque, grip and their place; the other members of ToolLoad keep their defaults.
    ToolLoad load() const;

  private:
    double grip_un() const;

    const Tool& tool_;
    Vec3 centre_mm_;
    std::vector<double> pressed_open_un_;  // of each part: the work of its contacts for each
                                           // millimetre of opening
    ToolLoad load_;                        // its at_mm is the force-weighted sum so far
    double pressed_un_ = 0.0;
};

}  // namespace hepatica
