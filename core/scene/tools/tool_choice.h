// SPDX-License-Identifier: GPL-3.0-or-later
// Tools as a person names them, and their conversion to Tool. Each kind has its own file.
#pragma once

#include <optional>
#include <string>

#include "core/base/vector.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

struct ToolChoice {
    std::string kind = "sphere";  // sphere, capsule, forceps or hook
    double radius_mm = 3.0;       // 0.1 to 100
    double length_mm = 0.0;       // except for spheres; between the centres of its ends, 0 to 1000
    Vec3 direction = Vec3::UnitZ();  // of its approach and of its length
    // The side towards which jaws open and a foot points, without its component along the
    // direction; not parallel to it. None: any.
    std::optional<Vec3> side{};
};

// The tool at its destination, see tool_kinds.h. Its pad is a tenth of its radius, within limits,
// and as stiff as tissue with twice the vessels' modulus; its force limit is that of a hand with
// `hand_pressure_pa` on a vessel of its radius. Throws InputError for an unknown kind and for
// values out of range.
Tool tool_of(const ToolChoice& choice, const Vec3& point_mm, double modulus_pa,
             double hand_pressure_pa);

// The widest opening of its jaws: six of their radii between their surfaces; 0 without jaws.
double widest_opening_mm(const Tool& tool);

// The largest strain of a vessel in a hand or a tool.
inline constexpr double hand_strain = 0.4;

}  // namespace hepatica
