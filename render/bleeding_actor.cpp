// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bleeding_actor.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cmath>

#include "render/palette.h"

namespace hepatica {
namespace {

constexpr double pool_opacity = 0.55;  // low enough that the stump inside remains visible
// Changes below this are invisible; where only blood runs, no new picture is drawn for them.
constexpr double seen_mm = 0.1;

vtkSmartPointer<vtkActor> new_pool() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto pool = vtkSmartPointer<vtkActor>::New();
    pool->SetMapper(mapper);
    const Colour& colour = palette::bleeding;
    pool->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    pool->GetProperty()->SetOpacity(pool_opacity);
    pool->ForceOpaqueOn();  // blended over the vessels, which are drawn before it, without a
                            // separate translucent pass
    pool->GetProperty()->BackfaceCullingOn();
    pool->SetPickable(false);
    return pool;
}

}  // namespace

double radius_of_pool_mm(double lost_g) {
    constexpr double first_drop_mm = 2.0, per_cube_root_g = 2.0;
    return lost_g > 0.0 ? first_drop_mm + per_cube_root_g * std::cbrt(lost_g) : 0.0;
}

BleedingActor::~BleedingActor() {
    for (const auto& pool : pools_) renderer_.RemoveActor(pool);
}

bool BleedingActor::update(const std::optional<TearView>& tear) {
    const std::size_t count = tear ? tear->leaks.size() : 0;
    if (count == 0 && pools_.empty()) return false;
    bool changed = pools_.size() != count;
    for (; pools_.size() > count; pools_.pop_back()) renderer_.RemoveActor(pools_.back());
    while (pools_.size() < count) {
        pools_.push_back(new_pool());
        renderer_.AddActor(pools_.back());
    }
    for (std::size_t i = 0; i < count; ++i) {
        const LeakView& leak = tear->leaks[i];
        const double radius_mm = radius_of_pool_mm(leak.share * tear->leaked_g);
        vtkActor& pool = *pools_[i];
        const Vec3 drawn_at(pool.GetPosition());
        const bool grown = std::abs(radius_mm - pool.GetScale()[0]) >= seen_mm;
        const bool moved = (leak.at_mm - drawn_at).norm() >= seen_mm;
        const bool visible = radius_mm > 0.0;
        if (!grown && !moved && visible == (pool.GetVisibility() != 0)) continue;
        pool.SetPosition(leak.at_mm.x(), leak.at_mm.y(), leak.at_mm.z());
        pool.SetScale(radius_mm);
        pool.SetVisibility(visible);
        changed = true;
    }
    return changed;
}

}  // namespace hepatica
