// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/touching_blocks.h"

#include <algorithm>

#include "core/mesh/brick_mesh.h"

namespace hepatica {

namespace {

constexpr int layers = 3;
constexpr double layers_mm = layers * study_cell_mm;

TetMesh brick(int cells) {
    const double wide = cells * study_cell_mm;
    return kuhn_brick(Vec3(wide, wide, layers_mm), {cells, cells, layers});
}

void append(const TetMesh& more, TetMesh& mesh) {
    const int first = static_cast<int>(mesh.vertices_mm.size());
    mesh.vertices_mm.insert(mesh.vertices_mm.end(), more.vertices_mm.begin(),
                            more.vertices_mm.end());
    for (auto nodes : more.tetrahedra) {
        for (int& node : nodes) node += first;
        mesh.tetrahedra.push_back(nodes);
    }
}

}  // namespace

Material study_tissue() {
    return {.young_modulus_pa = 2e4,
            .poisson_ratio = 0.3,
            .density_g_mm3 = 1e-3,
            .damping_ratio = 0.05};
}

TouchingBlocks block_on_slab(int slab_cells, int block_cells, double gap_mm) {
    TouchingBlocks blocks;
    BodyDescription& body = blocks.body;
    body.mesh = brick(slab_cells);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < 1e-9 ? 1 : 0);
    blocks.first_of_block = static_cast<int>(body.mesh.vertices_mm.size());
    TetMesh block = brick(block_cells);
    // Shifted against the vertices below, as the meshes of real surfaces do not match.
    const double from = 0.5 * (slab_cells - block_cells) * study_cell_mm;
    for (Vec3& x : block.vertices_mm)
        x += Vec3(from + 0.31 * study_cell_mm, from + 0.17 * study_cell_mm, layers_mm + gap_mm);
    append(block, body.mesh);
    body.fixed.resize(body.mesh.vertices_mm.size(), 0);
    body.material = study_tissue();
    body.self.emplace();
    return blocks;
}

BodyDescription slab_held_at_rim(int cells) {
    BodyDescription body;
    body.mesh = brick(cells);
    const double wide = cells * study_cell_mm;
    for (const Vec3& x : body.mesh.vertices_mm)
        body.fixed.push_back(std::min({x.x(), x.y(), wide - x.x(), wide - x.y()}) < 1e-9 ? 1 : 0);
    body.material = study_tissue();
    return body;
}

}  // namespace hepatica
