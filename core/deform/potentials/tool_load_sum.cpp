// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_load_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/deform/potentials/tool_contact.h"
#include "core/deform/potentials/tool_friction.h"

namespace hepatica {

ToolLoad load_of(const ToolContact& contact, const ToolFriction& friction,
                 std::span<const Vec3> positions_mm, double dt_s) {
    ToolLoadSum sum(*contact.tool());
    const std::vector<PadContact> contacts = contact.contacts(positions_mm);
    for (const PadContact& pressed : contacts) sum.press(pressed);
    for (const auto& point : friction.point_forces(positions_mm))
        sum.drag(point.at_mm, point.force_un);
    const Vec3 of_body_un = sum.load().force_un;
    const ToolContact::ObstaclePress obstacles = contact.pressed_by_obstacles();
    for (const PadContact& pressed : obstacles.contacts) sum.press(pressed, obstacles.share);
    ToolLoad load = sum.load();
    load.impulse_un_s = dt_s * of_body_un;
    load.contacts = static_cast<int>(contacts.size());
    for (const PadContact& pressed : contacts)
        for (const int node : contact.nodes_of(pressed)) load.touched.push_back(node);
    std::ranges::sort(load.touched);
    load.touched.erase(std::unique(load.touched.begin(), load.touched.end()), load.touched.end());
    load.least_gap_mm = std::min(contact.least_gap_mm(positions_mm), obstacles.least_gap_mm);
    return load;
}

void ToolLoadSum::press(const PadContact& contact, double share) {
    const double size = share * contact.force_un;
    const Vec3 force = size * contact.normal;
    drag(contact.at_mm, force);
    load_.at_mm += size * contact.at_mm;
    pressed_un_ += size;
    pressed_open_un_[contact.part] -= force.dot(tool_.parts[contact.part].opens);
}

void ToolLoadSum::drag(const Vec3& at_mm, const Vec3& on_touched_un) {
    load_.force_un -= on_touched_un;
    load_.torque_un_mm -= (at_mm - centre_mm_).cross(on_touched_un);
}

// A jaw moves by half of the opening, so that twice its share is its normal force.
double ToolLoadSum::grip_un() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t part = 0; part < tool_.parts.size(); ++part)
        if (!tool_.parts[part].opens.isZero(0.0)) least = std::min(least, pressed_open_un_[part]);
    return std::isfinite(least) ? std::max(0.0, 2.0 * least) : 0.0;
}

ToolLoad ToolLoadSum::load() const {
    ToolLoad load = load_;
    if (pressed_un_ > 0.0) load.at_mm /= pressed_un_;
    load.grip_un = grip_un();
    return load;
}

}  // namespace hepatica
