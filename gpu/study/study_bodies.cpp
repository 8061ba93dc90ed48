// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/study/study_bodies.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/brick_mesh.h"

namespace hepatica::gpu {
namespace {

constexpr double cell_mm = 1.5;
constexpr int across = 4, per_cell = 6;
// The tether of a vessel in a scene (SceneSpec); without it a bar of metres would swing in free
// fall.
constexpr double tether_pa_per_mm2 = 20.0;

}  // namespace

BodyDescription slender_bar(int tetrahedra) {
    const int slice = per_cell * across * across;
    const int along = std::max(1, (tetrahedra + slice - 1) / slice);
    constexpr int side = across + 1;
    BodyDescription body;
    body.tether_pa_per_mm2 = tether_pa_per_mm2;
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j < side; ++j)
            for (int k = 0; k < side; ++k) {
                body.mesh.vertices_mm.push_back(cell_mm * Vec3(i, j, k));
                body.fixed.push_back(i == 0 ? 1 : 0);
            }
    // Kuhn's six tetrahedra follow the paths along three edges from one corner to the opposite one.
    constexpr int step[3] = {side * side, side, 1};
    constexpr int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j)
            for (int k = 0; k < across; ++k)
                for (int p = 0; p < per_cell; ++p) {
                    const int a = i * step[0] + j * step[1] + k;
                    const int b = a + step[paths[p][0]], c = b + step[paths[p][1]];
                    const int d = c + step[paths[p][2]];
                    // The last three are mirror images, so two corners are swapped.
                    body.mesh.tetrahedra.push_back(p < 3 ? std::array{a, b, c, d}
                                                         : std::array{a, c, b, d});
                }
    return body;
}

BodyDescription slab_above_a_block(int contacts) {
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(contacts))) - 1);
    BodyDescription body;
    body.mesh = kuhn_brick(cell_mm * Vec3(side, side, 1), {side, side, 1});
    const double pad_mm =
        build_body(body, ElementModel::corotated, ElementOrder::linear).mean_edge_mm *
        SelfPad{}.thickness_edges;
    // The block extends beyond the slab, and no vertex of the slab lies over the diagonal of the
    // block's face, where it would touch two triangles.
    TetMesh block = kuhn_brick(cell_mm * Vec3(side + 8, side + 8, 4), {1, 1, 1});
    for (Vec3& x : block.vertices_mm)
        x -= Vec3(4.4 * cell_mm, 4.0 * cell_mm, 4.0 * cell_mm + slab_clearance_pads * pad_mm);
    Obstacle obstacle{{block.vertices_mm, boundary_triangles(block)}};
    body.obstacles = std::make_shared<const Obstacles>(Obstacles{{std::move(obstacle)}});
    return body;
}

}  // namespace hepatica::gpu
