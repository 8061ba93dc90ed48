// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_obstacle.h"

#include <algorithm>
#include <numeric>

#include "core/contact/point_in_surface.h"

namespace hepatica {

ToolObstacle::ToolObstacle(const Obstacle& obstacle)
    : obstacle_(obstacle),
      pad_(SurfacePatches(obstacle.surface.triangles), obstacle.surface.vertices_mm),
      boxes_(boxes_of_patches(pad_.surface(), obstacle.surface.vertices_mm)),
      patches_(pad_.surface().size()) {
    std::iota(patches_.begin(), patches_.end(), 0);
}

bool ToolObstacle::stops(const Tool& tool) const {
    if (obstacle_.kind == SurfaceKind::solid) return true;
    return std::ranges::all_of(tool.parts,
                               [&](const ToolPart& part) { return !meets(part) && holds(part); });
}

bool ToolObstacle::entered_by(const Tool& tool) const {
    return obstacle_.kind == SurfaceKind::solid &&
           std::ranges::any_of(tool.parts,
                               [&](const ToolPart& part) { return meets(part) || holds(part); });
}

bool ToolObstacle::meets(const ToolPart& part) const {
    return !near_capsule(part.shape, pad_.surface(), obstacle_.surface.vertices_mm, 0.0).empty();
}

// For a part that does not meet the surface, which is then wholly inside or wholly outside.
bool ToolObstacle::holds(const ToolPart& part) const {
    return lies_within(part.shape.centre_mm, pad_.surface(), patches_, boxes_,
                       obstacle_.surface.vertices_mm);
}

std::vector<PadContact> ToolObstacle::contacts(const Tool& tool,
                                               std::span<const Capsule> shapes) const {
    return pad_.contacts(tool, shapes, obstacle_.surface.vertices_mm);
}

double ToolObstacle::least_gap_mm(const Tool& tool) const {
    return pad_.least_gap_mm(tool, obstacle_.surface.vertices_mm);
}

}  // namespace hepatica
