// SPDX-License-Identifier: GPL-3.0-or-later
// Tools as a person names them, made into what the step knows. Each kind has a file of its own.
#pragma once

#include <optional>
#include <string>

#include "core/base/vector.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

struct ToolChoice {
    std::string kind = "sphere";  // sphere, capsule, forceps or hook
    double radius_mm = 3.0;       // 0.1 to 100
    double length_mm = 0.0;       // of all but a sphere, between the middles of its ends, 0 to 1000
    Vec3 direction = Vec3::UnitZ();  // in which it comes, and which its length has
    // To which jaws open and a foot points, as far as that is square to the direction; not along
    // it. None: any.
    std::optional<Vec3> side{};
};

// The tool where it has arrived at a point. Its pad is a tenth of its radius, within bounds, and
// gives way like tissue twice as stiff as the vessels; it is as strong as a hand of that pressure
// on a vessel of its own radius. Throws InputError for a kind that is not known and for values out
// of range.
Tool tool_of(const ToolChoice& choice, const Vec3& point_mm, double modulus_pa,
             double hand_pressure_pa);

// How far its jaws may open: six of their radii from surface to surface; 0 where it has none.
double widest_opening_mm(const Tool& tool);

// The most that a hand, or what it holds, stretches a vessel.
inline constexpr double hand_strain = 0.4;

}  // namespace hepatica
