// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for the studies of the linear solvers: bent bars of any slenderness, and vessel trees.
#pragma once

#include "core/base/job.h"
#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A bar along x, `slenderness` times as long as wide (6 mm), clamped at x = 0, cut into Kuhn
// bricks, with its centreline as skeleton.
BodyDescription study_bar(double slenderness, int cells_across);

// A symmetric tree whose every branch, eight diameters long at the root and less further out,
// forks into two of 0.79 times its radius (Murray's law) in alternating planes.
VesselTree study_tree(int generations, double root_radius_mm);

// The tree as tetrahedra, about `tetrahedra` of them, clamped at the roots, its centrelines as
// skeleton.
BodyDescription body_of(const VesselTree& tree, int tetrahedra, Job& job);

CoarseSkeleton skeleton_of(const VesselTree& tree);

// The middle of the clamped vertices; the origin where there is none.
Vec3 clamp_mm(const BodyDescription& body);
// The vertex furthest from there.
int furthest_vertex(const BodyDescription& body);

// A pull by a compliant spring at the vertex, whose target is led around a circle of 2 mm across
// that begins at `start_mm`, once in two seconds at 60 frames a second.
Grab led_around(int vertex, const Vec3& start_mm, int frame);

// Positions bent into an arc in the x-y plane: `angle_rad` over the body's length along x.
std::vector<Vec3> bent(std::vector<Vec3> positions_mm, double angle_rad);

}  // namespace hepatica
