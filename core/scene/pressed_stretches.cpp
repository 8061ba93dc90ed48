// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pressed_stretches.h"

#include <algorithm>
#include <map>

namespace hepatica {

std::vector<double> vertex_areas_mm2(std::span<const std::array<int, 3>> triangles,
                                     std::span<const Vec3> vertices_mm) {
    std::vector<double> areas(vertices_mm.size(), 0.0);
    for (const auto& [a, b, c] : triangles) {
        const Vec3 one = vertices_mm[b] - vertices_mm[a], other = vertices_mm[c] - vertices_mm[a];
        for (const int v : {a, b, c}) areas[v] += one.cross(other).norm() / 6.0;
    }
    return areas;
}

std::vector<PressedStretch> pressed_stretches(const ToolLoad& load,
                                              std::span<const VertexPlace> places,
                                              std::span<const double> areas_mm2) {
    double area_mm2 = 0.0;
    std::map<int, PressedStretch> by_segment;
    std::map<int, double> radius_mm;
    for (const int v : load.touched) {
        const auto& [on_tree, radius] = places[v];
        area_mm2 += areas_mm2[v];
        const double along = on_tree.arclength_mm;
        auto [found, is_new] =
            by_segment.try_emplace(on_tree.segment, PressedStretch{on_tree.segment, along, along});
        PressedStretch& stretch = found->second;
        stretch.from_mm = std::min(stretch.from_mm, along);
        stretch.to_mm = std::max(stretch.to_mm, along);
        radius_mm[on_tree.segment] = std::max(radius_mm[on_tree.segment], radius);
    }
    // Each of two jaws presses on its half with the grip.
    const double force_un = std::max(load.force_un.norm(), 2.0 * load.grip_un);
    std::vector<PressedStretch> stretches;
    if (!(area_mm2 > 0.0) || !(force_un > 0.0)) return stretches;
    for (auto& [segment, stretch] : by_segment) {
        const double lacks =
            0.5 * std::max(0.0, radius_mm[segment] - (stretch.to_mm - stretch.from_mm));
        stretch.from_mm = std::max(0.0, stretch.from_mm - lacks);
        stretch.to_mm += lacks;
        stretch.pressure_pa = force_un / area_mm2;  // 1 uN/mm2 is 1 Pa
        stretches.push_back(stretch);
    }
    return stretches;
}

}  // namespace hepatica
