// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paper/skeleton_frame.h"

#include <array>

namespace hepatica {
namespace {

constexpr double reach = 0.9;  // half the size of a bead in voxels
// Vertices 2 a and 2 a + 1 are on the negative and positive side along axis a. Counter-clockwise
// seen from outside.
constexpr std::array<std::array<int, 3>, 8> faces{
    {{1, 3, 5}, {3, 0, 5}, {0, 2, 5}, {2, 1, 5}, {3, 1, 4}, {0, 3, 4}, {2, 0, 4}, {1, 2, 4}}};

}  // namespace

SkeletonFrame frame_of_skeleton(const Mask& skeleton) {
    SkeletonFrame made;
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t i = 0; i < skeleton.voxels.size(); ++i) {
        if (skeleton.voxels[i] == 0) continue;
        ++made.voxels;
        const auto [x, y, z] = skeleton.grid.index_of(i);
        const int first = static_cast<int>(made.vertices_mm.size());
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-reach, reach})
                made.vertices_mm.push_back(
                    skeleton.grid.to_mm(Vec3(x, y, z) + side * Vec3::Unit(axis)));
        for (const auto& [a, b, c] : faces) triangles.push_back({first + a, first + b, first + c});
    }
    for (const Vec3& vertex : made.vertices_mm)
        for (const double coordinate : vertex)
            made.frame.positions_mm.push_back(static_cast<float>(coordinate));
    made.frame.topology_version = 1;
    made.frame.surface =
        std::make_shared<const std::vector<std::array<int, 3>>>(std::move(triangles));
    return made;
}

}  // namespace hepatica
