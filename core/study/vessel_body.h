// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for the studies of the solvers: bars of any slenderness, which may be bent, and vessel
// trees.
#pragma once

#include "core/base/job.h"
#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A bar along x, 6 mm wide and `slenderness` times as long, clamped at x = 0, of Kuhn bricks, with
// its centreline as skeleton.
BodyDescription study_bar(double slenderness, int cells_across);

// A symmetric tree of `generations` >= 1: every branch forks into two with 0.79 times its radius
// (Murray's law), in alternating planes. The root is five diameters long, the other branches seven.
VesselTree study_tree(int generations, double root_radius_mm);

// Meshes the tree with about `tetrahedra` tetrahedra, clamps it at the roots, and takes its
// centrelines as skeleton. Throws Cancelled.
BodyDescription body_of(const VesselTree& tree, int tetrahedra, Job& job);

CoarseSkeleton skeleton_of(const VesselTree& tree);

// The centroid of the clamped vertices; the origin where there are none.
Vec3 clamp_mm(const BodyDescription& body);
// The vertex furthest from clamp_mm().
int furthest_vertex(const BodyDescription& body);

// A pull by a compliant spring at the vertex. Its target moves around a circle of 2 mm radius that
// begins at `start_mm`, about once in two seconds at 60 frames a second.
Grab led_around(int vertex, const Vec3& start_mm, int frame);

// Bends positions into an arc in the x-y plane, by `angle_rad` > 0 over the body's length along x.
std::vector<Vec3> bent(std::vector<Vec3> positions_mm, double angle_rad);

}  // namespace hepatica
