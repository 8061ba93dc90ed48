// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the straight branches of the grown trees into vessels: smooth, slightly tortuous
// centrelines with tapering radii that obey Murray's law at every bifurcation.
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
    std::vector<StraightVessel> obstacles;  // vessels of the other systems
};

// Adds one system to the tree. A centreline that would touch a vessel it is not connected to is
// drawn straighter, down to its chord.
void append_system(VesselTree& tree, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request, PhantomRandom& random);

// Appends the straight branches with the largest radii that they can have.
void append_chords(std::vector<StraightVessel>& vessels, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request);

// A straight vessel for each edge of each centreline, with the larger of its two radii.
std::vector<StraightVessel> straight_vessels_of(const VesselTree& tree);

}  // namespace hepatica
