// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/touching_blocks.h"

#include <algorithm>
#include <utility>

#include "core/mesh/brick_mesh.h"

namespace hepatica {

namespace {

constexpr int layers = 3;
constexpr double layers_mm = layers * study_cell_mm;

// Cells along x and y.
TetMesh brick(int along, int across) {
    return kuhn_brick(Vec3(along * study_cell_mm, across * study_cell_mm, layers_mm),
                      {along, across, layers});
}

TetMesh brick(int cells) {
    return brick(cells, cells);
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

// `upper` on `lower`, whose bottom is fixed; `from_mm`: from the lower corner to the upper one.
TouchingBlocks laid_on(TetMesh lower, TetMesh upper, const Vec3& from_mm) {
    TouchingBlocks blocks;
    BodyDescription& body = blocks.body;
    body.mesh = std::move(lower);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < 1e-9 ? 1 : 0);
    blocks.first_of_block = static_cast<int>(body.mesh.vertices_mm.size());
    // Shifted against the vertices below, as the meshes of real surfaces do not match.
    const Vec3 shift(0.31 * study_cell_mm, 0.17 * study_cell_mm, 0.0);
    for (Vec3& x : upper.vertices_mm) x += from_mm + shift;
    append(upper, body.mesh);
    body.fixed.resize(body.mesh.vertices_mm.size(), 0);
    body.material = study_tissue();
    body.self.emplace();
    return blocks;
}

}  // namespace

TouchingBlocks block_on_slab(int slab_cells, int block_cells, double gap_mm) {
    const double from_mm = 0.5 * (slab_cells - block_cells) * study_cell_mm;
    return laid_on(brick(slab_cells), brick(block_cells),
                   Vec3(from_mm, from_mm, layers_mm + gap_mm));
}

TouchingBlocks bar_along_bar(int lower_cells, int upper_cells, double gap_mm) {
    const double from_mm = 0.5 * (lower_cells - upper_cells) * study_cell_mm;
    return laid_on(brick(lower_cells, layers), brick(upper_cells, layers),
                   Vec3(from_mm, 0.0, layers_mm + gap_mm));
}

Material study_tissue() {
    return {.young_modulus_pa = 2e4,
            .poisson_ratio = 0.3,
            .density_g_mm3 = 1e-3,
            .damping_ratio = 0.05};
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
