// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices on a lattice, x fastest.
#include "core/mesh/brick_mesh.h"

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace hepatica {
namespace {

std::vector<Vec3> lattice(const Vec3& size, const Index3& cells) {
    for (int i = 0; i < 3; ++i)
        if (!(size[i] > 0.0) || !std::isfinite(size[i]) || cells[i] < 1)
            throw InputError("a box of " + number_text(size[i]) + " mm in " +
                                 std::to_string(cells[i]) + " cells has no volume",
                             "brick mesh", "Give a positive size and at least one cell");
    std::vector<Vec3> vertices;
    vertices.reserve(static_cast<std::size_t>(cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1));
    for (int k = 0; k <= cells[2]; ++k)
        for (int j = 0; j <= cells[1]; ++j)
            for (int i = 0; i <= cells[0]; ++i)
                vertices.emplace_back(size[0] * i / cells[0], size[1] * j / cells[1],
                                      size[2] * k / cells[2]);
    return vertices;
}

}  // namespace

TetMesh kuhn_brick(const Vec3& size_mm, const Index3& cells) {
    HexMesh brick = hexahedral_brick(size_mm, cells);
    return {std::move(brick.vertices_mm), cut_into_tetrahedra(brick.hexahedra)};
}

HexMesh hexahedral_brick(const Vec3& size_mm, const Index3& cells) {
    HexMesh mesh{lattice(size_mm, cells), {}};
    const int row = cells[0] + 1, layer = row * (cells[1] + 1);
    for (int k = 0; k < cells[2]; ++k)
        for (int j = 0; j < cells[1]; ++j)
            for (int i = 0; i < cells[0]; ++i) {
                const int base = i + row * j + layer * k, above = base + layer;
                mesh.hexahedra.push_back({base, base + 1, base + row + 1, base + row, above,
                                          above + 1, above + row + 1, above + row});
            }
    return mesh;
}

}  // namespace hepatica
