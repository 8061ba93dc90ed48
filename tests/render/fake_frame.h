// SPDX-License-Identifier: GPL-3.0-or-later
// A small tree of tubes with arrival times, for pictures that need no patient.
#pragma once

#include "core/mesh/tet_mesh.h"
#include "core/scene/frame.h"

namespace hepatica::testing {

// Three generations of branching tubes, some 120 mm tall. `bend` in [-1, 1] sways its tip sideways.
Frame fake_frame(double bend = 0.0, double drug_time_s = -1.0);

// The bent tree with a rod that presses its trunk.
Frame touched_frame();

// The tree, swayed aside, with a tumour beside its trunk and the liver's wall around.
Frame frame_beside_obstacles();

// Latitudes and longitudes; outward triangles.
TriangleMesh sphere(const Vec3& centre_mm, double radius_mm);

}  // namespace hepatica::testing
