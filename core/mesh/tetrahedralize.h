// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel tree becomes tetrahedra: the smooth union of its round cones (see tube_field.h) meshed
// by CGAL's Delaunay refinement (Mesh_3) with sizes that follow the local radius.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tet_mesh.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct MeshOptions {
    // Edges of surface triangles and of tetrahedra, in local radii; 0.3 to 1.
    double facet_size_in_radii = 0.9;
    double cell_size_in_radii = 1.0;
    // Above 0: sizes are scaled, within the range above, until there are about so many tetrahedra.
    int target_tetrahedra = 0;
    // Vessels thinner than this are meshed as if they were so wide; 0 keeps them as they are.
    double minimum_radius_mm = 0.0;
    // Remove slivers after refinement (perturb, then exude).
    bool optimise = true;
};

// Each connected component of the tree (links of loops included) becomes one closed component of
// the mesh; components that overlap in space stay separate bodies. Every branch is present however
// thin it is. The volume equals that of the round cones within a few per cent: the surface is moved
// out by what the flat triangles cut off.
// A body whose surface meets itself at every size of elements that is tried is told in `warnings`,
// in words for the user; without `warnings` it is refused by InputError.
// Same tree, same options: the same bytes. Throws InputError if the tree is empty, not valid, or
// longer than a million of its radii, and Cancelled. Thread safety: any number of calls at once.
TetMesh tetrahedralize(const VesselTree& tree, const MeshOptions& options, Job& job,
                       std::vector<std::string>* warnings = nullptr);

}  // namespace hepatica
