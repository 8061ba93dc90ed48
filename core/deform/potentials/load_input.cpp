// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/load_input.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace hepatica {
namespace {

void validate_grab(const Grab& grab, std::size_t nodes, std::size_t index) {
    const auto reject = [&](const std::string& problem, const std::string& remedy) {
        throw InputError(problem, "grab " + std::to_string(index), remedy);
    };
    double sum = 0.0;
    for (int a = 0; a < 4; ++a) {
        const int node = grab.vertices[a];
        if (node < 0 ? a == 0 : static_cast<std::size_t>(node) >= nodes)
            reject("holds vertex " + std::to_string(node) + ", which does not exist",
                   "Pick a point of the body");
        if (node >= 0) sum += grab.weights[a];
    }
    if (!(std::abs(sum - 1.0) < 1e-6))
        reject("has weights that sum to " + number_text(sum), "Make them sum to 1");
    if (!grab.target_mm.allFinite()) reject("has a target that is not finite", "Give a finite one");
    if (!(grab.stiffness_un_per_mm > 0.0) || !std::isfinite(grab.stiffness_un_per_mm))
        reject("has a stiffness of " + number_text(grab.stiffness_un_per_mm) + " uN/mm",
               "Give a finite value greater than 0");
    if (!(grab.force_limit_un > 0.0) || !std::isfinite(grab.force_limit_un))
        reject("has a force limit of " + number_text(grab.force_limit_un) + " uN",
               "Give a finite value greater than 0");
}

}  // namespace

void validate_gravity(const Vec3& gravity_mm_per_s2) {
    if (!gravity_mm_per_s2.allFinite())
        throw InputError("gravity is not finite", "gravity", "Give a finite acceleration in mm/s2");
}

void validate_grabs(std::span<const Grab> grabs, std::size_t nodes) {
    for (std::size_t i = 0; i < grabs.size(); ++i) validate_grab(grabs[i], nodes, i);
}

void validate_tool(const Tool& tool, bool touchable) {
    const auto require = [](bool good, const std::string& problem) {
        if (!good) throw InputError(problem, "the tool", "Give another value");
    };
    if (!touchable)
        throw InputError("has nothing to touch", "the tool",
                         "Name tools among the contacts of the scene");
    const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
    require(!tool.parts.empty(), "has no parts");
    for (const ToolPart& part : tool.parts) {
        require(part.shape.centre_mm.allFinite() && part.shape.half_axis_mm.allFinite() &&
                    part.opens.allFinite(),
                "is at a place that is not finite");
        require(part.led_by_mm.allFinite() && part.led_half_axis_mm.allFinite(),
                "was led by what is not finite");
        require(positive(part.shape.radius_mm),
                "has a radius of " + number_text(part.shape.radius_mm) + " mm");
    }
    require(tool.target_mm.allFinite() && tool.turn_rad.allFinite(),
            "has a target that is not finite");
    constexpr double one_turn_rad = 6.3;
    require(tool.turn_rad.norm() <= one_turn_rad, "has more than a turn to go");
    require(positive(tool.led_over_s), "was led over " + number_text(tool.led_over_s) + " s");
    for (const double opening : {tool.opening_mm, tool.opening_target_mm})
        require(opening >= 0.0 && std::isfinite(opening),
                "is open by " + number_text(opening) + " mm");
    require(positive(tool.pad_mm), "has a pad of " + number_text(tool.pad_mm) + " mm");
    for (std::size_t k = 0; k < tool.thin_pads.size(); ++k) {
        const ThinPad& thin = tool.thin_pads[k];
        require(positive(thin.pad_mm) && thin.pad_mm < tool.pad_mm,
                "has a thin pad of " + number_text(thin.pad_mm) + " mm");
        require(std::ranges::is_sorted(thin.corners) && thin.corners[0] >= 0 &&
                    (k == 0 || tool.thin_pads[k - 1].corners < thin.corners),
                "has thin pads that are not in order");
    }
    require(positive(tool.pressure_pa), "has a pad of " + number_text(tool.pressure_pa) + " Pa");
    require(tool.friction >= 0.0 && std::isfinite(tool.friction),
            "has a friction of " + number_text(tool.friction));
    require(positive(tool.force_limit_un),
            "has a force limit of " + number_text(tool.force_limit_un) + " uN");
}

}  // namespace hepatica
