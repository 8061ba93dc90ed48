// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tools/tool_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/patient_space.h"
#include "core/scene/tools/tool_kinds.h"

namespace hepatica {
namespace {

using Make = void (*)(Tool&, const ToolChoice&, const Vec3& direction, const Vec3& point_mm);

constexpr std::array<std::pair<std::string_view, Make>, 4> kinds{{
    {"sphere", make_probe},
    {"capsule", make_probe},
    {"forceps", make_forceps},
    {"hook", make_hook},
}};

}  // namespace

Vec3 side_of(const ToolChoice& choice, const Vec3& direction) {
    if (!choice.side) return direction.unitOrthogonal();
    const Vec3 square = *choice.side - choice.side->dot(direction) * direction;
    if (!(square.norm() > 1e-6 * choice.side->norm()) || !square.allFinite())
        throw InputError("has a side that is not beside its direction", "the tool",
                         "Give three finite numbers that are not along the direction");
    return square.normalized();
}

double widest_opening_mm(const Tool& tool) {
    const ToolPart& part = tool.parts.front();
    return part.opens.isZero(0.0) ? 0.0 : jaws_open_to_radii * part.shape.radius_mm;
}

Tool tool_of(const ToolChoice& choice, const Vec3& point_mm, double modulus_pa,
             double hand_pressure_pa) {
    const auto require = [](bool good, const std::string& problem, const std::string& remedy) {
        if (!good) throw InputError(problem, "the tool", remedy);
    };
    const auto kind = std::ranges::find(kinds, std::string_view(choice.kind),
                                        [](const auto& entry) { return entry.first; });
    std::string names;
    for (const auto& entry : kinds) names += (names.empty() ? "" : ", ") + std::string(entry.first);
    require(kind != kinds.end(), "is a \"" + choice.kind + "\"", "Choose one of: " + names);
    require(choice.radius_mm >= 0.1 && choice.radius_mm <= 100.0,
            "has a radius of " + number_text(choice.radius_mm) + " mm", "Give 0.1 to 100 mm");
    require(choice.length_mm >= 0.0 && choice.length_mm <= 1000.0,
            "has a length of " + number_text(choice.length_mm) + " mm", "Give 0 to 1000 mm");
    require(choice.direction.allFinite() && choice.direction.norm() > 0.0, "has no direction",
            "Give three finite numbers that are not all 0");
    require_reachable(point_mm, "the place of the tool");
    Tool tool;
    tool.pad_mm = std::clamp(0.1 * choice.radius_mm, 0.1, 0.5);
    kind->second(tool, choice, choice.direction.normalized(), point_mm);
    tool.pressure_pa = 2.0 * modulus_pa;
    tool.force_limit_un = hand_pressure_pa * M_PI * choice.radius_mm * choice.radius_mm;
    return tool;
}

}  // namespace hepatica
