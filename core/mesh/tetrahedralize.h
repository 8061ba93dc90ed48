// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedral mesh of a vessel tree: the smooth union of its round cones (see tube_field.h) meshed
// by CGAL's Delaunay refinement (Mesh_3) with element sizes proportional to the local radius.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tet_mesh.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct MeshOptions {
    // Largest circumradius of surface triangles and of tetrahedra, in local radii; 0.3 to 1.
    double facet_size_in_radii = 0.9;
    double cell_size_in_radii = 1.0;
    // If above 0, the sizes are scaled, within the range above, to give about this number.
    int target_tetrahedra = 0;
    // Vessels thinner than this are meshed with this radius, 0 to 50; 0 keeps them as they are.
    double minimum_radius_mm = 0.0;
    // Remove slivers after refinement (perturb, then exude).
    bool optimise = true;
};

// Each connected component of the tree (links of loops included) becomes one closed component of
// the mesh; components that overlap in space stay separate bodies. Every branch is present, however
// thin. The volume equals that of the round cones within a few per cent: the surface is moved
// outwards to compensate for the volume that flat triangles cut off.
// A body whose surface meets itself at every tried element size is reported in `warnings`, in words
// for the user; if `warnings` is null, InputError is thrown instead.
// The same tree and options give the same bytes. Throws InputError if the tree is empty, not valid,
// or longer than a million of its radii, or an option is out of range; Cancelled. Thread-safe.
TetMesh tetrahedralize(const VesselTree& tree, const MeshOptions& options, Job& job,
                       std::vector<std::string>* warnings = nullptr);

}  // namespace hepatica
