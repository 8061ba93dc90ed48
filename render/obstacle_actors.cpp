// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/obstacle_actors.h"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

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

}  // namespace hepatica
