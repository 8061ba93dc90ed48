// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/level_surface.h"

#include <array>
#include <utility>

namespace hepatica {
namespace {

constexpr float level = 0.5f;

// A cell is numbered by its lowest voxel; its vertex is -1 where the surface does not pass it.
class Net {
  public:
    explicit Net(const FloatVolume& share) : share_(share), vertex_of_(share.grid, -1) {}

    TriangleMesh make() {
        const Index3& dims = share_.grid.dims;
        for (int z = 0; z + 1 < dims[2]; ++z)
            for (int y = 0; y + 1 < dims[1]; ++y)
                for (int x = 0; x + 1 < dims[0]; ++x) add_vertex({x, y, z});
        for (int z = 0; z + 1 < dims[2]; ++z)
            for (int y = 0; y + 1 < dims[1]; ++y)
                for (int x = 0; x + 1 < dims[0]; ++x)
                    for (std::size_t axis = 0; axis < 3; ++axis) add_quadrangle({x, y, z}, axis);
        return std::move(mesh_);
    }

  private:
    float at(const Index3& i) const { return share_.at(i[0], i[1], i[2]); }
    bool inside(const Index3& i) const { return at(i) >= level; }

    // Places the vertex at the mean of the points where the surface cuts the cell's edges.
    void add_vertex(const Index3& cell) {
        Vec3 sum = Vec3::Zero();
        int cuts = 0;
        for (int corner = 0; corner < 8; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) != 0) continue;
                Index3 from = cell;
                for (std::size_t a = 0; a < 3; ++a) from[a] += corner >> a & 1;
                Index3 to = from;
                ++to[axis];
                if (inside(from) == inside(to)) continue;
                const double along = (level - at(from)) / (at(to) - at(from));
                Vec3 cut(from[0], from[1], from[2]);
                cut[static_cast<Eigen::Index>(axis)] += along;
                sum += cut;
                ++cuts;
            }
        if (cuts == 0) return;
        vertex_of_.at(cell[0], cell[1], cell[2]) = static_cast<int>(mesh_.vertices_mm.size());
        mesh_.vertices_mm.push_back(share_.grid.to_mm(Vec3(sum / cuts)));
    }

    // Adds the quadrangle of the four cells around the edge from a voxel to the next one.
    void add_quadrangle(const Index3& from, std::size_t axis) {
        Index3 to = from;
        ++to[axis];
        if (inside(from) == inside(to)) return;
        const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
        if (from[b] == 0 || from[c] == 0) return;
        constexpr std::array<std::array<int, 2>, 4> around{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
        std::array<int, 4> v{};
        for (std::size_t k = 0; k < 4; ++k) {
            Index3 cell = from;
            cell[b] -= around[k][0];
            cell[c] -= around[k][1];
            v[k] = vertex_of_.at(cell[0], cell[1], cell[2]);
        }
        const bool right_handed = share_.grid.direction.determinant() > 0.0;
        if (inside(from) != right_handed) std::swap(v[1], v[3]);
        const auto apart = [&](int i, int j) {
            return (mesh_.vertices_mm[v[i]] - mesh_.vertices_mm[v[j]]).squaredNorm();
        };
        if (apart(1, 3) < apart(0, 2)) v = {v[1], v[2], v[3], v[0]};
        mesh_.triangles.push_back({v[0], v[1], v[2]});
        mesh_.triangles.push_back({v[0], v[2], v[3]});
    }

    const FloatVolume& share_;
    Image<int> vertex_of_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh level_surface(const FloatVolume& share) {
    return Net(share).make();
}

}  // namespace hepatica
