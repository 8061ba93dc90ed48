// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/obstacle_actors.h"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "render/actor_settings.h"
#include "render/still_surface.h"

namespace hepatica {
namespace {

// All obstacles of one kind, merged into one surface.
TriangleMesh all_of(const Obstacles& obstacles, SurfaceKind kind) {
    TriangleMesh all;
    for (const Obstacle& obstacle : obstacles.all) {
        if (obstacle.kind != kind) continue;
        const auto first = static_cast<int>(all.vertices_mm.size());
        const auto& vertices = obstacle.surface.vertices_mm;
        all.vertices_mm.insert(all.vertices_mm.end(), vertices.begin(), vertices.end());
        for (const auto& [a, b, c] : obstacle.surface.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

// Points in cubes as wide as the distance within which they are looked for. Each cube is a leaf of
// an ordered tree: a look costs the logarithm of their number. What lies at a point is mostly in
// its own cube, which is looked into first.
class PointsNearby {
  public:
    void add(const Vec3& point_mm) { cubes_[cube_of(point_mm)].push_back(point_mm); }
    bool any_at(const Vec3& place_mm) const {
        const auto [i, j, k] = cube_of(place_mm);
        if (holds_near({i, j, k}, place_mm)) return true;
        for (int z = k - 1; z <= k + 1; ++z)
            for (int y = j - 1; y <= j + 1; ++y)
                for (int x = i - 1; x <= i + 1; ++x)
                    if (holds_near({x, y, z}, place_mm)) return true;
        return false;
    }

  private:
    using Cube = std::array<int, 3>;
    static constexpr double near_mm = 4.5;

    static Cube cube_of(const Vec3& point_mm) {
        Cube cube{};
        for (int axis = 0; axis < 3; ++axis)
            cube[static_cast<std::size_t>(axis)] =
                static_cast<int>(std::floor(point_mm[axis] / near_mm));
        return cube;
    }
    bool holds_near(const Cube& cube, const Vec3& place_mm) const {
        const auto found = cubes_.find(cube);
        return found != cubes_.end() &&
               std::ranges::any_of(found->second, [&place_mm](const Vec3& point_mm) {
                   return (point_mm - place_mm).squaredNorm() <= near_mm * near_mm;
               });
    }

    std::map<Cube, std::vector<Vec3>> cubes_;
};

}  // namespace

ObstacleActors::ObstacleActors(vtkRenderer& renderer)
    : renderer_(renderer),
      mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()),
      solids_(vtkSmartPointer<vtkActor>::New()) {
    solids_->SetMapper(mapper_);
    vtkProperty& look = *solids_->GetProperty();
    look.SetColor(palette::tumour[0], palette::tumour[1], palette::tumour[2]);
    look.SetAmbient(0.15);
    look.SetSpecular(0.15);
    look.SetSpecularPower(20.0);
    look.BackfaceCullingOn();
    solids_->SetVisibility(false);
    renderer_.AddActor(solids_);
    renderer_.AddActor(wall_.actor());
}

ObstacleActors::~ObstacleActors() {
    renderer_.RemoveActor(solids_);
    renderer_.RemoveActor(wall_.actor());
}

bool ObstacleActors::update(const std::shared_ptr<const Obstacles>& obstacles) {
    if (obstacles == shown_) return false;
    shown_ = obstacles;
    const Obstacles none;
    const TriangleMesh solids = all_of(obstacles ? *obstacles : none, SurfaceKind::solid);
    wall_.set_surface(all_of(obstacles ? *obstacles : none, SurfaceKind::shell));
    mapper_->SetInputData(still_surface(solids));
    has_solids_ = !solids.triangles.empty();
    solids_->SetVisibility(has_solids_);
    return true;
}

void ObstacleActors::set_clip(vtkPlane* plane) {
    wall_.set_clip(plane);
    clip_by(plane, *mapper_, *solids_);
}

TriangleMesh ObstacleActors::parts_beside_solids(const TriangleMesh& surface) const {
    if (!has_solids_) return surface;
    PointsNearby solids;
    for (const Obstacle& obstacle : shown_->all)
        if (obstacle.kind == SurfaceKind::solid)
            for (const Vec3& vertex_mm : obstacle.surface.vertices_mm) solids.add(vertex_mm);
    DisjointSets parts(surface.vertices_mm.size());
    for (const auto& triangle : surface.triangles)
        for (const int corner : triangle)
            parts.unite(static_cast<std::uint32_t>(triangle[0]),
                        static_cast<std::uint32_t>(corner));
    std::vector<bool> beside(surface.vertices_mm.size(), false);  // for the root of each part
    for (std::size_t v = 0; v < surface.vertices_mm.size(); ++v) {
        const std::uint32_t part = parts.root(static_cast<std::uint32_t>(v));
        if (!beside[part]) beside[part] = !solids.any_at(surface.vertices_mm[v]);
    }
    TriangleMesh shown;
    shown.vertices_mm = surface.vertices_mm;
    std::ranges::copy_if(surface.triangles, std::back_inserter(shown.triangles),
                         [&](const std::array<int, 3>& triangle) -> bool {
                             return beside[parts.root(static_cast<std::uint32_t>(triangle[0]))];
                         });
    return shown;
}

}  // namespace hepatica
