// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/brick_mesh.h"

#include <cmath>
#include <string>

#include "core/base/error.h"

namespace hepatica {
namespace {

std::vector<Vec3> lattice(const Vec3& size, const Index3& cells) {
    for (int i = 0; i < 3; ++i)
        if (!(size[i] > 0.0) || !std::isfinite(size[i]) || cells[i] < 1)
            throw InputError("a box of " + std::to_string(size[i]) + " mm in " +
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

// Calls visit(corner) for each cell; corner[b] has bit 0 of b for x, bit 1 for y, bit 2 for z.
template <class Visit>
void for_each_cell(const Index3& cells, const Visit& visit) {
    const int row = cells[0] + 1, layer = row * (cells[1] + 1);
    for (int k = 0; k < cells[2]; ++k)
        for (int j = 0; j < cells[1]; ++j)
            for (int i = 0; i < cells[0]; ++i) {
                const int base = i + row * j + layer * k;
                std::array<int, 8> corner;
                for (int b = 0; b < 8; ++b)
                    corner[b] = base + (b & 1) + row * ((b >> 1) & 1) + layer * (b >> 2);
                visit(corner);
            }
}

}  // namespace

TetMesh kuhn_brick(const Vec3& size_mm, const Index3& cells) {
    TetMesh mesh{lattice(size_mm, cells), {}};
    // Paths from corner 0 to corner 7 along one axis at a time; odd permutations swap two corners
    // to keep the orientation.
    constexpr int paths[6][4] = {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7},
                                 {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}};
    for_each_cell(cells, [&](const std::array<int, 8>& corner) {
        for (const auto& path : paths)
            mesh.tetrahedra.push_back(
                {corner[path[0]], corner[path[1]], corner[path[2]], corner[path[3]]});
    });
    return mesh;
}

HexMesh hexahedral_brick(const Vec3& size_mm, const Index3& cells) {
    HexMesh mesh{lattice(size_mm, cells), {}};
    for_each_cell(cells, [&](const std::array<int, 8>& c) {
        mesh.hexahedra.push_back({c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]});
    });
    return mesh;
}

void bend_along_x(std::vector<Vec3>& vertices_mm, double length_mm, double middle_y_mm,
                  double angle_rad) {
    const double radius = length_mm / angle_rad;
    for (Vec3& x : vertices_mm) {
        const double turn = angle_rad * x[0] / length_mm, r = radius - (x[1] - middle_y_mm);
        x = Vec3(r * std::sin(turn), middle_y_mm + radius - r * std::cos(turn), x[2]);
    }
}

}  // namespace hepatica
