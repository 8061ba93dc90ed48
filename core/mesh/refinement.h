// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay refinement of one implicit tube body by CGAL's Mesh_3: this is the only room of the
// program that compiles CGAL.
#pragma once

#include <functional>

#include "core/mesh/tet_mesh.h"
#include "core/mesh/tube_field.h"

namespace hepatica {

struct RefinementOptions {
    double facet_size_in_radii = 0.9;  // circumradius of the surface triangles, in local radii
    double cell_size_in_radii = 1.0;   // circumradius of the tetrahedra, in local radii
    bool optimise = true;              // perturb and exude slivers
};

// on_calls(n) is called after every n evaluations of the field, to report progress; what it throws
// (Cancelled) ends the meshing. Vertices that no tetrahedron uses are dropped; tetrahedra are
// right-handed. Deterministic. Thread safety: any number of calls at once.
TetMesh refine_tetrahedra(const TubeField& field, const RefinementOptions& options,
                          const std::function<void(int)>& on_calls);

}  // namespace hepatica
