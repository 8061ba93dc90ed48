// SPDX-License-Identifier: GPL-3.0-or-later
// Quality of a mesh as a simulated body: the shape of its tetrahedra and the topology of its
// boundary.
#pragma once

#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct MeshQuality {
    double min_dihedral_deg = 0.0;
    double max_dihedral_deg = 0.0;
    double volume_mm3 = 0.0;
    int components = 0;  // bodies: tetrahedra connected through shared vertices
    // Every boundary edge belongs to exactly two triangles, and the triangles around every boundary
    // vertex form one fan.
    bool closed = false;
    int boundary_components = 0;  // more than `components` means cavities
    int handles = 0;              // tunnels: 1 - chi/2, summed over the components of the boundary
};

// Zeros for an empty mesh. `handles` holds for a closed boundary. Thread-safe.
MeshQuality quality_of(const TetMesh& mesh);

// Smallest and largest of the six dihedral angles, in degrees.
struct DihedralRange {
    double min_deg = 0.0;
    double max_deg = 0.0;
};
DihedralRange dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace hepatica
