// SPDX-License-Identifier: GPL-3.0-or-later
// The joints along which a cut line weakens a vessel.
#include "core/scene/cut_line.h"

#include <gtest/gtest.h>

#include "core/base/disjoint_sets.h"
#include "core/mesh/surface.h"
#include "core/scene/vertex_places.h"
#include "core/tear/torn_topology.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

// Without the joints of a section nothing leads from a vessel's beginning to its end, wherever the
// section lies: also next to a fork, where the tetrahedra belong to several branches.
TEST(CutLine, ASectionPartsTheVesselNearForksToo) {
    const auto patient = test::small_patient();
    const VesselTree& tree = patient->tree;
    const TetMesh& mesh = patient->mesh;
    const TornTopology topology(mesh);
    std::vector<Vec3> centres;
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        centres.push_back(0.25 * (mesh.vertices_mm[a] + mesh.vertices_mm[b] + mesh.vertices_mm[c] +
                                  mesh.vertices_mm[d]));
    const std::vector<VertexPlace> places = places_of(centres, tree);
    const auto nearest = [&](int segment, double share) {
        const double at = share * length_mm(tree.segments[static_cast<std::size_t>(segment)]);
        std::size_t best = 0;
        double least = 1e9;
        for (std::size_t t = 0; t < places.size(); ++t)
            if (const double off = std::abs(places[t].on_tree.arclength_mm - at);
                places[t].on_tree.segment == segment && off < least) {
                least = off;
                best = t;
            }
        return best;
    };
    int sections = 0;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const double length = length_mm(tree.segments[s]);
        const double radius = tree.segments[s].radii_mm.front();
        for (const double from_end :
             {0.3, 0.6, 0.9, 1.2, -0.3, -0.6, -0.9, -1.2, 0.5 * length / radius}) {
            const double share =
                (from_end < 0.0 ? length + from_end * radius : from_end * radius) / length;
            const TreePoint at{static_cast<int>(s), share * length, 0.0};
            const std::vector<int> across =
                joints_along(tree, topology.joints(), places, at, at, 1.0);
            EXPECT_FALSE(across.empty()) << s << " at " << share;
            DisjointSets pieces(mesh.tetrahedra.size());
            for (std::size_t j = 0; j < topology.joints().size(); ++j) {
                if (std::ranges::binary_search(across, static_cast<int>(j))) continue;
                const auto& [one, other] = topology.joints()[j].tetrahedra;
                pieces.unite(static_cast<std::uint32_t>(one), static_cast<std::uint32_t>(other));
            }
            const auto begin = pieces.root(static_cast<std::uint32_t>(nearest(0, 0.0)));
            const auto end =
                pieces.root(static_cast<std::uint32_t>(nearest(static_cast<int>(s), 1.0)));
            EXPECT_NE(begin, end) << s << " at " << share;
            ++sections;
        }
    }
    EXPECT_GT(sections, 60);
}

}  // namespace
}  // namespace hepatica
