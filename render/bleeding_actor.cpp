// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bleeding_actor.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <numbers>

#include "core/flow/fluid.h"
#include "render/actor_settings.h"
#include "render/palette.h"

namespace hepatica {
namespace {

constexpr double pool_opacity = 0.55;  // low enough that the stump inside remains visible
// Changes below this are invisible; where only blood runs, no new picture is drawn for them.
constexpr double seen_mm = 0.1;

constexpr double cloud_opacity = 0.3;

vtkSmartPointer<vtkActor> new_leak_ball(const Colour& colour, double opacity) {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto ball = vtkSmartPointer<vtkActor>::New();
    ball->SetMapper(mapper);
    ball->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    ball->GetProperty()->SetOpacity(opacity);
    ball->ForceOpaqueOn();  // blended over the vessels, which are drawn before it, without a
                            // separate translucent pass
    ball->GetProperty()->BackfaceCullingOn();
    ball->SetPickable(false);
    return ball;
}

// Returns true where the picture changed.
bool show_leak_ball(vtkActor& ball, const Vec3& at_mm, double radius_mm, bool visible) {
    const bool was_visible = ball.GetVisibility() != 0;
    if (!visible && !was_visible) return false;
    const Vec3 drawn_at(ball.GetPosition());
    const bool grown = std::abs(radius_mm - ball.GetScale()[0]) >= seen_mm;
    const bool moved = (at_mm - drawn_at).norm() >= seen_mm;
    if (!grown && !moved && visible == was_visible) return false;
    ball.SetPosition(at_mm.x(), at_mm.y(), at_mm.z());
    ball.SetScale(radius_mm);
    ball.SetVisibility(visible);
    return true;
}

}  // namespace

double radius_of_pool_mm(double lost_g) {
    if (lost_g <= 0.0) return 0.0;
    const double drawn_mm3 = drawn_share_of_blood * lost_g / blood().density_g_mm3;
    return std::cbrt(0.75 * drawn_mm3 / std::numbers::pi);
}

BleedingActor::~BleedingActor() {
    for (const auto& pool : pools_) renderer_.RemoveActor(pool);
    for (const auto& cloud : clouds_) renderer_.RemoveActor(cloud);
}

void BleedingActor::set_clip(vtkPlane* plane) {
    clip_ = plane;
    for (const auto* balls : {&pools_, &clouds_})
        for (const auto& ball : *balls) clip_by(plane, *ball->GetMapper());
}

bool BleedingActor::update(const std::optional<TearView>& tear) {
    const std::size_t count = tear && visible_ ? tear->leaks.size() : 0;
    if (count == 0 && pools_.empty()) return false;
    bool changed = pools_.size() != count;
    for (; pools_.size() > count; pools_.pop_back(), clouds_.pop_back()) {
        renderer_.RemoveActor(pools_.back());
        renderer_.RemoveActor(clouds_.back());
    }
    while (pools_.size() < count) {
        pools_.push_back(new_leak_ball(palette::bleeding, pool_opacity));
        clouds_.push_back(new_leak_ball(palette::drug(1.0), cloud_opacity));
        clouds_.back()->SetVisibility(false);
        for (const auto& ball : {pools_.back(), clouds_.back()}) clip_by(clip_, *ball->GetMapper());
        renderer_.AddActor(pools_.back());
        renderer_.AddActor(clouds_.back());
    }
    for (std::size_t i = 0; i < count; ++i) {
        const LeakView& leak = tear->leaks[i];
        // The drug is part of what was lost.
        const double lost_g = leak.share * tear->leaked_g;
        const double cloud_mm = radius_of_pool_mm(lost_g);
        const double pool_mm = radius_of_pool_mm(lost_g - leak.drug_g);
        const bool drug_is_seen = cloud_mm >= pool_mm + seen_mm;
        if (show_leak_ball(*pools_[i], leak.at_mm, pool_mm, pool_mm > 0.0)) changed = true;
        if (show_leak_ball(*clouds_[i], leak.at_mm, cloud_mm, drug_is_seen)) changed = true;
    }
    return changed;
}

}  // namespace hepatica
