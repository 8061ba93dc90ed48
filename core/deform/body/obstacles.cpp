// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/obstacles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/surface.h"

namespace hepatica {

WithObstacles with_obstacles(const Obstacles& obstacles, std::span<const Vec3> positions_mm,
                             std::span<const std::array<int, 3>> triangles) {
    WithObstacles both{{positions_mm.begin(), positions_mm.end()},
                       {triangles.begin(), triangles.end()},
                       std::vector(positions_mm.size(), SurfaceKind::moving)};
    for (const Obstacle& obstacle : obstacles.all) {
        const TriangleMesh& surface = obstacle.surface;
        const auto first = static_cast<int>(both.positions_mm.size());
        both.positions_mm.insert(both.positions_mm.end(), surface.vertices_mm.begin(),
                                 surface.vertices_mm.end());
        both.kinds.resize(both.positions_mm.size(), obstacle.kind);
        for (const auto& [a, b, c] : surface.triangles)
            both.triangles.push_back({first + a, first + b, first + c});
    }
    return both;
}

void validate(const Obstacles& obstacles) {
    const auto require = [](bool good, const std::string& problem) {
        if (!good) throw InputError(problem, "the obstacles", "Give other ones or none");
    };
    require(!obstacles.all.empty(), "are none");
    require(obstacles.friction >= 0.0 && std::isfinite(obstacles.friction),
            "have a friction of " + number_text(obstacles.friction));
    for (const Obstacle& obstacle : obstacles.all) {
        const auto& vertices = obstacle.surface.vertices_mm;
        require(!obstacle.surface.triangles.empty(), "have a surface without triangles");
        require(std::ranges::all_of(vertices, [](const Vec3& x) { return x.allFinite(); }),
                "have a vertex that is not finite");
        for (const auto& triangle : obstacle.surface.triangles)
            for (const int v : triangle)
                require(v >= 0 && static_cast<std::size_t>(v) < vertices.size(),
                        "name vertex " + std::to_string(v) + ", which does not exist");
        require(obstacle.kind != SurfaceKind::moving, "have a surface that moves");
        validate_closed(obstacle.surface);
    }
}

}  // namespace hepatica
