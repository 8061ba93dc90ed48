// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of cubes, whose cubes are told their vessels.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/scene/origins_of.h"
#include "core/scene/vertex_places.h"
#include "core/tear/tearing.h"
#include "core/tree/vessel_tree.h"

namespace hepatica::test {

// Cubes of 1 mm in vessels of 0.5 mm radius, each of six tetrahedra around its diagonal, so that
// cubes side by side share triangles.
struct CubeBody {
    void add(int x, int y, int segment, double arclength_mm, int z = 0, double distance_mm = 0.0) {
        std::array<int, 3> axes{0, 1, 2};
        do {
            std::array<int, 3> at{x, y, z};
            std::array<int, 4> corners{vertex(at)};
            for (std::size_t k = 0; k < 3; ++k) {
                ++at[static_cast<std::size_t>(axes[k])];
                corners[k + 1] = vertex(at);
            }
            if (volume_of(corners) < 0.0) std::swap(corners[2], corners[3]);
            mesh.tetrahedra.push_back(corners);
            places.push_back({{segment, arclength_mm, distance_mm}, 0.5});
        } while (std::ranges::next_permutation(axes).found);
    }

    int vertex(const std::array<int, 3>& at) {
        const auto [found, fresh] = numbers.try_emplace(at, int(mesh.vertices_mm.size()));
        if (fresh) mesh.vertices_mm.push_back(Vec3(at[0], at[1], at[2]));
        return found->second;
    }

    double volume_of(const std::array<int, 4>& t) const {
        const auto edge = [&](int k) -> Vec3 {
            return mesh.vertices_mm[std::size_t(t[std::size_t(k)])] -
                   mesh.vertices_mm[std::size_t(t[0])];
        };
        return edge(1).cross(edge(2)).dot(edge(3));
    }

    // Of all vertices, those that were split off, too.
    std::vector<Vec3> rest_of(const Tearing& tearing) const {
        std::vector<Vec3> at;
        for (const int origin : origins_of(tearing.topology()))
            at.push_back(mesh.vertices_mm[std::size_t(origin)]);
        return at;
    }

    // Across the row of cubes at this y, between x - 1 and x.
    void cut(Tearing& tearing, double x, double y) const {
        const std::vector<int> joints =
            tearing.crossing(Vec3(x, y, -1.0), Vec3(0, 1, 0), Vec3(0, 0, 3), rest_of(tearing));
        ASSERT_FALSE(joints.empty());
        tearing.cut(joints);
    }

    TetMesh mesh;
    std::vector<VertexPlace> places;
    std::map<std::array<int, 3>, int> numbers;
};

inline VesselTree tree_of(const std::vector<int>& parents) {
    VesselTree tree;
    for (const int parent : parents) {
        VesselSegment segment;
        segment.parent = parent;
        segment.points_mm = {Vec3(0, 0, 0), Vec3(30, 0, 0)};
        segment.radii_mm = {0.5, 0.5};
        tree.segments.push_back(segment);
    }
    return tree;
}

}  // namespace hepatica::test
