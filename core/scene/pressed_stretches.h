// SPDX-License-Identifier: GPL-3.0-or-later
// Where on the vessel tree a tool presses, and with what pressure: its force over the surface that
// it touches; jaws press from both sides.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/potentials/tool.h"
#include "core/scene/vertex_places.h"

namespace hepatica {

struct PressedStretch {
    int segment = -1;  // of the tree
    double from_mm = 0.0, to_mm = 0.0;
    double pressure_pa = 0.0;
    bool operator==(const PressedStretch&) const = default;
};

// Distributes the area of each triangle equally to its vertices.
std::vector<double> vertex_areas_mm2(std::span<const std::array<int, 3>> triangles,
                                     std::span<const Vec3> vertices_mm);

// One entry for each touched segment, in ascending order, at least a radius long. `places` and
// `areas_mm2` are per vertex.
std::vector<PressedStretch> pressed_stretches(const ToolLoad& load,
                                              std::span<const VertexPlace> places,
                                              std::span<const double> areas_mm2);

}  // namespace hepatica
