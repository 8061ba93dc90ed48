// SPDX-License-Identifier: GPL-3.0-or-later
// Sums the normal and friction forces on a tool.
#pragma once

#include <span>
#include <vector>

#include "core/deform/potentials/tool_pad.h"

namespace hepatica {

class ToolContact;
class ToolFriction;

// The load on a tool, which there must be: by the body, friction included, and by obstacles. The
// impulse is the body's force times dt_s. positions_mm: one per node of the body.
ToolLoad load_of(const ToolContact& contact, const ToolFriction& friction,
                 std::span<const Vec3> positions_mm, double dt_s);

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
