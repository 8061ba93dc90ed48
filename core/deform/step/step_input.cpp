// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/step_input.h"

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace hepatica {

void validate_time_step(double dt_s) {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s))
        throw InputError("a step of " + number_text(dt_s) + " s", "the clock",
                         "Give a finite time greater than 0");
}

void validate_state(std::span<const Vec3> positions_mm, std::span<const Vec3> velocities_mm_per_s,
                    std::size_t expected) {
    const auto check = [&](std::span<const Vec3> values, const std::string& name) {
        if (values.size() != expected)
            throw InputError(
                std::to_string(values.size()) + " values instead of " + std::to_string(expected),
                name, "Give one value per vertex, or one per node as state() does");
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!values[i].allFinite())
                throw InputError("is not finite", name + " of vertex " + std::to_string(i),
                                 "Give finite values");
    };
    check(positions_mm, "position");
    check(velocities_mm_per_s, "velocity");
}

}  // namespace hepatica
