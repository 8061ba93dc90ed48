// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool.h"

#include <algorithm>

namespace hepatica {

Vec3 Tool::centre_mm() const {
    Vec3 sum = Vec3::Zero();
    for (const ToolPart& part : parts) sum += part.shape.centre_mm;
    return sum / static_cast<double>(parts.size());
}

std::vector<Capsule> Tool::shapes() const {
    std::vector<Capsule> all;
    for (const ToolPart& part : parts) all.push_back(part.shape);
    return all;
}

std::vector<Capsule> Tool::shapes_before_led() const {
    std::vector<Capsule> all = shapes();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        all[i].centre_mm -= parts[i].led_by_mm;
        all[i].half_axis_mm -= parts[i].led_half_axis_mm;
    }
    return all;
}

double Tool::speed_mm_per_s() const {
    double farthest = 0.0;
    for (const ToolPart& part : parts)
        for (const double end : {-1.0, 1.0})
            farthest = std::max(farthest, (part.led_by_mm + end * part.led_half_axis_mm).norm());
    return farthest / led_over_s;
}

double Tool::reach_mm() const {
    const Vec3 centre = centre_mm();
    double farthest = 0.0;
    for (const ToolPart& part : parts)
        for (const Vec3& end : part.shape.axis())
            farthest = std::max(farthest, (end - centre).norm() + part.shape.radius_mm);
    return farthest;
}

Tool single_tool(const Capsule& shape) {
    Tool tool;
    tool.parts.push_back({.shape = shape});
    tool.target_mm = shape.centre_mm;
    return tool;
}

}  // namespace hepatica
