// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay refinement of an implicit tube body by CGAL's Mesh_3. No other room than core/mesh
// compiles CGAL.
#pragma once

#include <functional>

#include "core/mesh/tet_mesh.h"
#include "core/mesh/tube_field.h"

namespace hepatica {

struct MeshRefinementOptions {
    double facet_size_in_radii = 0.9;  // circumradius of the surface triangles, in local radii
    double cell_size_in_radii = 1.0;   // circumradius of the tetrahedra, in local radii
    bool optimise = true;              // perturb and exude slivers
};

// on_calls(n) is called after every n evaluations of the field, or with 0 in between, to report
// progress; an exception from it (Cancelled) ends the meshing. Vertices without a tetrahedron are
// dropped; tetrahedra are right-handed. Deterministic and thread-safe.
TetMesh refine_tetrahedra(const TubeField& field, const MeshRefinementOptions& options,
                          const std::function<void(int)>& on_calls);

}  // namespace hepatica
