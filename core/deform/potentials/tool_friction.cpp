// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_friction.h"

#include <algorithm>
#include <cmath>

namespace hepatica {

std::vector<Grip> ToolFriction::grips_of(std::span<const Vec3> start_mm, double dt_s) const {
    std::vector<Grip> grips;
    if (!contact_.tool() || contact_.tool()->friction == 0.0) return grips;
    std::vector<PadContact> touching = contact_.contacts_before_led(start_mm);
    // In a later part of a step the body may have moved to where the tool was before.
    const auto closed = [](const PadContact& contact) { return !std::isfinite(contact.energy_nj); };
    if (std::ranges::any_of(touching, closed)) touching = contact_.contacts(start_mm);
    for (const PadContact& contact : touching) {
        Grip grip{contact_.nodes_of(contact), contact.weights, contact.normal,
                  contact_.tool()->friction * contact.force_un, Vec3::Zero()};
        const ToolPart& part = contact_.tool()->parts[contact.part];
        const Vec3 led = part.led_by_mm + (2.0 * contact.along - 1.0) * part.led_half_axis_mm;
        const Vec3 dragged = dt_s * (led / contact_.tool()->led_over_s);
        grip.anchor_mm = grip.point(start_mm) + dragged;
        grips.push_back(grip);
    }
    return grips;
}

}  // namespace hepatica
