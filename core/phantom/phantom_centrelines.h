// SPDX-License-Identifier: GPL-3.0-or-later
// From the straight branches that were grown to the vessels that are drawn: smooth, slightly
// tortuous centrelines with tapering radii that obey Murray's law at every bifurcation.
#pragma once

#include <span>
#include <vector>

#include "core/phantom/phantom_growth.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct CentrelineRequest {
    double root_radius_mm = 6.0;
    double murray_exponent = 3.0;
    double point_spacing_mm = 1.0;
    VascularSystem system = VascularSystem::portal;
    std::vector<Capsule> obstacles;  // vessels of the other systems
};

// Adds one system to the tree. A centreline that would touch a vessel it does not meet is drawn
// straighter until it does not.
void append_system(VesselTree& tree, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request, PhantomRandom& random);

// The straight branches with the radii that they will have at most.
void append_chords(std::vector<Capsule>& capsules, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request);

// Every piece of every centreline, with the larger of its two radii.
std::vector<Capsule> capsules_of(const VesselTree& tree);

}  // namespace hepatica
