// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of bars that may touch each other: bricks put side by side, turned and moved.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica::test {

// Of the box [0, size], about its middle turned by `turn`, with its middle at `at_mm`.
inline TetMesh bar_at(const Vec3& size_mm, const Index3& cells, const Mat3& turn,
                      const Vec3& at_mm) {
    TetMesh mesh = kuhn_brick(size_mm, cells);
    for (Vec3& x : mesh.vertices_mm) x = turn * (x - 0.5 * size_mm) + at_mm;
    return mesh;
}

inline void add_mesh(const TetMesh& mesh, TetMesh& all) {
    const int first = static_cast<int>(all.vertices_mm.size());
    all.vertices_mm.insert(all.vertices_mm.end(), mesh.vertices_mm.begin(), mesh.vertices_mm.end());
    for (auto nodes : mesh.tetrahedra) {
        for (int& node : nodes) node += first;
        all.tetrahedra.push_back(nodes);
    }
}

inline Mat3 about_z(double angle_rad) {
    return Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()).toRotationMatrix();
}

// Two bars of 24 x 4 x 4 mm, one along x below, one across it above, with a gap between them.
inline BodyDescription crossed_bars(double gap_mm, double angle_rad = 1.4) {
    BodyDescription body;
    const Vec3 size(24, 4, 4);
    const Index3 cells{12, 2, 2};
    add_mesh(bar_at(size, cells, Mat3::Identity(), Vec3::Zero()), body.mesh);
    add_mesh(bar_at(size, cells, about_z(angle_rad), Vec3(0.3, 0.2, 4.0 + gap_mm)), body.mesh);
    body.self.emplace();
    return body;
}

}  // namespace hepatica::test
