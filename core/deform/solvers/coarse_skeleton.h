// SPDX-License-Identifier: GPL-3.0-or-later
// The centreline tree as the coarse grid of the deformation solver: nodes half to one diameter
// apart, each with an affine motion, and the binding of mesh vertices to them by weights that
// interpolate linearly between neighbouring nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// A forest of centreline nodes. All three arrays have one entry per node.
struct CoarseSkeleton {
    std::vector<Vec3> positions_mm;
    std::vector<int> parent;       // -1 at a root; a parent precedes its children
    std::vector<double> radii_mm;  // of the body around the node, > 0

    int size() const { return static_cast<int>(positions_mm.size()); }
};

// One centreline between bifurcations or ends, as reconstruction delivers it.
struct SkeletonPolyline {
    std::vector<Vec3> points_mm;   // at least one
    std::vector<double> radii_mm;  // one per point, > 0
    int parent = -1;               // the polyline at whose end this one begins; -1: none
};

// Resamples polylines (parents before children) to nodes `spacing_diameters` local diameters apart;
// a polyline shorter than a third of that adds no node. Throws InputError for sizes that do not
// match, parents out of order, non-finite points and radii <= 0.
CoarseSkeleton resample(std::span<const SkeletonPolyline> polylines,
                        double spacing_diameters = 0.5);

// A skeleton from the mesh alone: vertices are sorted by their distance along mesh edges from one
// end and cut into slices; every connected slice becomes a node. Loops are cut. One tree per
// connected component; a compact body gets few nodes or one.
CoarseSkeleton skeleton_of_mesh(const TetMesh& mesh, double spacing_diameters = 0.5);

// Checks the invariants of CoarseSkeleton; throws InputError that names the node.
void validate(const CoarseSkeleton& skeleton);

// Vertex v moves with the neighbouring nodes nodes[v][0] and nodes[v][1] by weights[v], which sum
// to 1. An isolated node stands in both places, with weights 1 and 0.
struct SkeletonBinding {
    std::vector<std::array<int, 2>> nodes;
    std::vector<std::array<double, 2>> weights;
};

// Binds each position to the nearest centreline edge. Distance is measured in local radii, so that
// a vertex on a wide parent is not bound to a thin child that leaves nearby. Any distance is
// accepted. Requires a valid skeleton of at least one node and finite positions.
SkeletonBinding bind_vertices(const CoarseSkeleton& skeleton, std::span<const Vec3> positions_mm);

}  // namespace hepatica
