// SPDX-License-Identifier: GPL-3.0-or-later
// Renumbering of the boundary and tests on its directed edges.
#include "core/mesh/surface.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/base/error.h"

namespace hepatica {

BodySurface surface_of(const TetMesh& body) {
    BodySurface surface;
    surface.mesh.triangles = boundary_triangles(body);
    std::vector<int> number(body.vertices_mm.size(), -1);
    for (const auto& triangle : surface.mesh.triangles)
        for (const int vertex : triangle) number[vertex] = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(surface.body_vertex.size());
        surface.body_vertex.push_back(static_cast<int>(v));
        surface.mesh.vertices_mm.push_back(body.vertices_mm[v]);
    }
    for (auto& triangle : surface.mesh.triangles)
        for (int& vertex : triangle) vertex = number[vertex];
    return surface;
}

void validate_closed(const TriangleMesh& surface) {
    const int vertices = static_cast<int>(surface.vertices_mm.size());
    std::vector<std::pair<int, int>> forward, backward;
    for (const auto& triangle : surface.triangles)
        for (int i = 0; i < 3; ++i) {
            const int a = triangle[i], b = triangle[(i + 1) % 3];
            if (a < 0 || a >= vertices)
                throw InputError("names vertex " + std::to_string(a) + ", which does not exist",
                                 "surface", "Reconstruct the patient again");
            if (a == b)
                throw InputError("has a triangle with vertex " + std::to_string(a) + " twice",
                                 "surface", "Reconstruct the patient again");
            forward.emplace_back(a, b);
            backward.emplace_back(b, a);
        }
    std::ranges::sort(forward);
    std::ranges::sort(backward);
    const auto [open, other] = std::ranges::mismatch(forward, backward);
    if (open == forward.end()) return;
    const auto [a, b] = std::min(*open, *other);
    throw InputError("is not closed at the edge between vertices " + std::to_string(a) + " and " +
                         std::to_string(b),
                     "surface", "Reconstruct the patient again");
}

bool is_closed_manifold(const TriangleMesh& surface) {
    std::map<std::pair<int, int>, int> opposite;  // directed edge to the third corner
    for (const auto& triangle : surface.triangles)
        for (int i = 0; i < 3; ++i)
            if (!opposite.try_emplace({triangle[i], triangle[(i + 1) % 3]}, triangle[(i + 2) % 3])
                     .second)
                return false;
    std::vector<int> triangles_at(surface.vertices_mm.size(), 0);
    std::vector<int> start(surface.vertices_mm.size(), -1);
    for (const auto& [edge, corner] : opposite) {
        if (!opposite.contains({edge.second, edge.first})) return false;
        ++triangles_at[edge.first];
        start[edge.first] = edge.second;
    }
    for (std::size_t v = 0; v < start.size(); ++v) {
        if (start[v] < 0) continue;
        const int centre = static_cast<int>(v);
        int turned = 0, rim = start[v];
        do {
            rim = opposite.at({centre, rim});
            ++turned;
        } while (rim != start[v] && turned <= triangles_at[v]);
        if (turned != triangles_at[v]) return false;
    }
    return true;
}

}  // namespace hepatica
