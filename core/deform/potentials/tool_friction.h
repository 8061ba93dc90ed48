// SPDX-License-Identifier: GPL-3.0-or-later
// Friction between a tool and the body: see CoulombFriction. A touched point is dragged along with
// the nearest point of the tool's axis.
#pragma once

#include <vector>

#include "core/deform/potentials/coulomb_friction.h"
#include "core/deform/potentials/tool_contact.h"

namespace hepatica {

// Keeps references to the body and the contact.
class ToolFriction final : public CoulombFriction {
  public:
    ToolFriction(const Body& body, const ToolContact& contact)
        : CoulombFriction(body), contact_(contact) {}

  private:
    std::vector<Grip> grips_of(std::span<const Vec3> start_mm, double dt_s) const override;

    const ToolContact& contact_;
};

}  // namespace hepatica
