// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/command_ranges.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "core/base/patient_space.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"

namespace hepatica {

namespace {

constexpr NumberRange place_range_mm{-farthest_mm, farthest_mm};
constexpr NumberRange vector_range{-1e6, 1e6};
constexpr NumberRange whole_share{0.0, 1.0};

// Narrower bounds, as that a share is above 0, are checked where the command is applied.
constexpr std::array ranges_of_fields{
    std::pair{"point_mm", place_range_mm},
    std::pair{"target_mm", place_range_mm},
    std::pair{"from_mm", place_range_mm},
    std::pair{"to_mm", place_range_mm},
    std::pair{"by_mm", NumberRange{-2.0 * farthest_mm, 2.0 * farthest_mm}},
    std::pair{"direction", vector_range},
    std::pair{"side", vector_range},
    std::pair{"by_rad", NumberRange{-1e3, 1e3}},
    std::pair{"radius_mm", NumberRange{0.0, 100.0}},
    std::pair{"length_mm", NumberRange{0.0, 1000.0}},
    std::pair{"wall_mm", NumberRange{0.0, thickest_wall_mm}},
    std::pair{"over_s", NumberRange{0.0, longest_move_s}},
    std::pair{"share", whole_share},
    std::pair{"strength", whole_share},
    std::pair{"quality", whole_share},
    std::pair{"void_fraction", whole_share},
    std::pair{"friction", NumberRange{0.0, greatest_friction}},
    std::pair{"tear_factor", NumberRange{least_tear_factor, greatest_tear_factor}},
    std::pair{"gravity_mm_per_s2", gravity_range_mm_per_s2},
    std::pair{"pa_per_mm2", tether_range_pa_per_mm2},
    std::pair{"mass_flow_g_s", NumberRange{1e-12, 1e15}},
    std::pair{"drug_viscosity_pa_s", NumberRange{1e-9, 1e6}},
    std::pair{"time_s", NumberRange{0.0, 1e15}},
    std::pair{"factor", drug_speed_range},
};

}  // namespace

NumberRange range_of(std::string_view field) {
    const auto* const found = std::ranges::find_if(
        ranges_of_fields, [field](const auto& entry) { return field == entry.first; });
    assert(found != ranges_of_fields.end());
    return found->second;
}

}  // namespace hepatica
