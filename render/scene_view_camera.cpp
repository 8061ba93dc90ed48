// SPDX-License-Identifier: GPL-3.0-or-later
// Where a SceneView looks from, and what lies under a pixel of its picture.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/flat_distance.h"
#include "render/scene_view.h"
#include "render/scene_view_parts.h"

namespace hepatica {

// Zooms so that what was visible stays visible when the picture gets narrower, and zooms back when
// it gets wider.
void SceneView::keep_in_sight() {
    const SurfaceGeometry& surface = parts_->tree.surface();
    const double aspect = parts_->aspect();
    if (surface.triangles().empty() || aspect == parts_->shown_aspect) return;
    const Vec3 size = surface.upper_mm() - surface.lower_mm();
    const ViewAxes view = axes();
    const double wanted = size.dot(view.right.cwiseAbs()) / size.dot(view.up.cwiseAbs());
    if (parts_->shown_aspect > 0.0)
        zoom_by(std::max(1.0, wanted / parts_->shown_aspect) / std::max(1.0, wanted / aspect));
    parts_->shown_aspect = aspect;
}

void SceneView::look_from(ViewDirection direction) {
    const SurfaceGeometry& surface = parts_->tree.surface();
    const bool empty = surface.triangles().empty();
    parts_->looked = !empty;
    parts_->turned = true;
    parts_->shown_aspect = empty ? 0.0 : parts_->aspect();
    hepatica::look_from(camera(), direction, empty ? Vec3::Constant(-50) : surface.lower_mm(),
                        empty ? Vec3::Constant(50) : surface.upper_mm(), parts_->aspect());
}

vtkCamera& SceneView::camera() {
    return *parts_->renderer->GetActiveCamera();
}

bool SceneView::look_as(SceneView& other) {
    vtkCamera& mine = camera();
    vtkCamera& theirs = other.camera();
    if (Vec3(mine.GetPosition()) == Vec3(theirs.GetPosition()) &&
        Vec3(mine.GetFocalPoint()) == Vec3(theirs.GetFocalPoint()) &&
        Vec3(mine.GetViewUp()) == Vec3(theirs.GetViewUp()) &&
        mine.GetViewAngle() == theirs.GetViewAngle())
        return false;
    mine.SetPosition(theirs.GetPosition());
    mine.SetFocalPoint(theirs.GetFocalPoint());
    mine.SetViewUp(theirs.GetViewUp());
    mine.SetViewAngle(theirs.GetViewAngle());
    parts_->looked = true;
    parts_->shown_aspect = parts_->aspect();
    return true;
}

ViewAxes SceneView::axes() const {
    return axes_of(*parts_->renderer->GetActiveCamera());
}

ViewRay SceneView::ray_through(const Pixel& pixel) const {
    return parts_->projection().ray_through(pixel);
}

SurfacePick SceneView::pick(const Pixel& pixel) const {
    const ViewRay ray = ray_through(pixel);
    return pick_surface(parts_->tree.surface(), ray.origin_mm, ray.direction, parts_->clip);
}

Vec3 SceneView::point_at_depth(const Pixel& pixel, const Vec3& depth_mm) const {
    return parts_->projection().point_at_depth(pixel, depth_mm);
}

Pixel SceneView::pixel_of(const Vec3& position_mm) const {
    return parts_->projection().pixel_of(position_mm);
}

int SceneView::bridge_at(const Pixel& pixel, double reach) const {
    int nearest = -1;
    double least = reach;
    const Projection projection = parts_->projection();
    const std::vector<BridgeView>& bridges = parts_->bridges.bridges();
    for (std::size_t b = 0; b < bridges.size(); ++b) {
        const std::vector<Vec3>& path = bridges[b].path_mm;
        for (std::size_t i = 1; i < path.size(); ++i) {
            if (!projection.sees(path[i - 1]) || !projection.sees(path[i])) continue;
            const Pixel from = projection.pixel_of(path[i - 1]), to = projection.pixel_of(path[i]);
            const double distance =
                distance_to_stretch({pixel.x, pixel.y}, {from.x, from.y}, {to.x, to.y});
            if (distance > least) continue;
            least = distance;
            nearest = static_cast<int>(b);
        }
    }
    return nearest;
}

// Counts only vertices in front of the eye.
std::vector<int> SceneView::vertices_within(const std::vector<PictureBox>& boxes) const {
    const PictureSize size = parts_->picture_size();
    const ViewAxes view = axes();
    vtkCamera& eye = *parts_->renderer->GetActiveCamera();
    const Vec3 origin(eye.GetPosition());
    const double per_depth =
        size.height / (2.0 * std::tan(0.5 * eye.GetViewAngle() * std::numbers::pi / 180.0));
    const std::vector<float>& at = parts_->tree.surface().positions_mm();
    std::vector<int> counts(boxes.size(), 0);
    for (std::size_t v = 0; v + 2 < at.size(); v += 3) {
        const Vec3 offset = Vec3(at[v], at[v + 1], at[v + 2]) - origin;
        const double depth = offset.dot(view.forward);
        if (depth <= 0.0) continue;
        const double x = 0.5 * size.width + per_depth * offset.dot(view.right) / depth;
        const double y = 0.5 * size.height + per_depth * offset.dot(view.up) / depth;
        for (std::size_t b = 0; b < boxes.size(); ++b)
            counts[b] += x >= boxes[b].left && x <= boxes[b].right && y >= boxes[b].bottom &&
                         y <= boxes[b].top;
    }
    return counts;
}

void SceneView::drag_orbit(const Pixel& from, const Pixel& to) {
    const double degrees_per_pixel = 240.0 / std::max(parts_->picture_size().height, 1);
    orbit(camera(), degrees_per_pixel * (to.x - from.x), -degrees_per_pixel * (to.y - from.y));
}

void SceneView::drag_pan(const Pixel& from, const Pixel& to) {
    const Vec3 focus(camera().GetFocalPoint());
    pan(camera(), point_at_depth(to, focus) - point_at_depth(from, focus));
}

void SceneView::zoom_by(double factor) {
    zoom(camera(), factor);
}

void SceneView::turn_by(double right_deg, double down_deg) {
    orbit(camera(), right_deg, -down_deg);
}

void SceneView::show_whole() {
    const SurfaceGeometry& surface = parts_->tree.surface();
    if (surface.triangles().empty()) return;
    look_at_all(camera(), surface.lower_mm(), surface.upper_mm(), parts_->aspect());
    parts_->turned = true;
    parts_->shown_aspect = parts_->aspect();
}

}  // namespace hepatica
