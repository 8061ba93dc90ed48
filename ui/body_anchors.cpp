// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/body_anchors.h"

#include <cstddef>

namespace hepatica {

const std::vector<Vec3>& rest_vertices(const PatientCase& patient, const Frame& frame) {
    const std::vector<Vec3>& body = patient.mesh.vertices_mm;
    const bool moves = !body.empty() && frame.positions_mm.size() >= 3 * body.size();
    return moves ? body : patient.surface.vertices_mm;
}

int nearest_vertex(const std::vector<Vec3>& vertices_mm, const Vec3& point_mm, double reach_mm) {
    int nearest = -1;
    double least = reach_mm * reach_mm;
    for (std::size_t v = 0; v < vertices_mm.size(); ++v) {
        const double square = (vertices_mm[v] - point_mm).squaredNorm();
        if (square >= least) continue;
        least = square;
        nearest = static_cast<int>(v);
    }
    return nearest;
}

Vec3 displacement_mm(int vertex, const std::vector<Vec3>& rest_mm, const Frame& frame) {
    const auto v = static_cast<std::size_t>(vertex);
    if (vertex < 0 || v >= rest_mm.size() || 3 * v + 2 >= frame.positions_mm.size())
        return Vec3::Zero();
    const float* at = &frame.positions_mm[3 * v];
    return Vec3(at[0], at[1], at[2]) - rest_mm[v];
}

}  // namespace hepatica
