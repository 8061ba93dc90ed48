// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hepatica {
namespace {

using std::numbers::pi;
constexpr double view_angle_deg =
    24.0;  // narrow, so that there is little perspective and lengths remain comparable

struct Side {
    ViewDirection direction;
    const char* name;
    Vec3 from;  // towards the camera
    Vec3 up;
};

const std::vector<Side>& sides() {
    static const std::vector<Side> table{
        {ViewDirection::anterior, "anterior", {0, -1, 0}, {0, 0, 1}},
        {ViewDirection::posterior, "posterior", {0, 1, 0}, {0, 0, 1}},
        {ViewDirection::left, "left", {1, 0, 0}, {0, 0, 1}},
        {ViewDirection::right, "right", {-1, 0, 0}, {0, 0, 1}},
        {ViewDirection::superior, "superior", {0, 0, 1}, {0, -1, 0}},
        {ViewDirection::inferior, "inferior", {0, 0, -1}, {0, -1, 0}},
    };
    return table;
}

const Side& side_of(ViewDirection direction) {
    return sides()[static_cast<std::size_t>(direction)];
}

// Places the camera so that the box fits. `from` points towards the eye, `up` is perpendicular to
// it; both have unit length.
void fit(vtkCamera& camera, const Vec3& from, const Vec3& up, const Vec3& lower_mm,
         const Vec3& upper_mm, double aspect) {
    const Vec3 centre = 0.5 * (lower_mm + upper_mm);
    const Vec3 half = (0.5 * (upper_mm - lower_mm)).cwiseMax(Vec3::Constant(1.0));
    const double half_height = half.dot(up.cwiseAbs());
    const double half_width = half.dot(up.cross(from).cwiseAbs());
    const double half_depth = half.dot(from.cwiseAbs());
    const double tangent = std::tan(0.5 * view_angle_deg * pi / 180.0);
    const double margin = 1.12;
    const double distance =
        margin * std::max(half_height, half_width / std::max(aspect, 1e-3)) / tangent + half_depth;
    const Vec3 eye = centre + distance * from;
    camera.SetViewAngle(view_angle_deg);
    camera.SetFocalPoint(centre.x(), centre.y(), centre.z());
    camera.SetPosition(eye.x(), eye.y(), eye.z());
    camera.SetViewUp(up.x(), up.y(), up.z());
}

}  // namespace

const std::vector<ViewDirection>& all_view_directions() {
    static const std::vector<ViewDirection> all{ViewDirection::anterior, ViewDirection::posterior,
                                                ViewDirection::left,     ViewDirection::right,
                                                ViewDirection::superior, ViewDirection::inferior};
    return all;
}

std::string name_of(ViewDirection direction) {
    return side_of(direction).name;
}

std::optional<ViewDirection> view_direction_named(const std::string& name) {
    for (const Side& side : sides()) {
        if (name == side.name) return side.direction;
    }
    return std::nullopt;
}

void look_from(vtkCamera& camera, ViewDirection direction, const Vec3& lower_mm,
               const Vec3& upper_mm, double aspect) {
    const Side& side = side_of(direction);
    fit(camera, side.from, side.up, lower_mm, upper_mm, aspect);
}

void look_at_all(vtkCamera& camera, const Vec3& lower_mm, const Vec3& upper_mm, double aspect) {
    const Vec3 from = (Vec3(camera.GetPosition()) - Vec3(camera.GetFocalPoint())).normalized();
    const Vec3 up(camera.GetViewUp());
    fit(camera, from, (up - up.dot(from) * from).normalized(), lower_mm, upper_mm, aspect);
}

void orbit(vtkCamera& camera, double right_deg, double up_deg) {
    camera.Azimuth(-right_deg);
    camera.Elevation(-up_deg);
    camera.OrthogonalizeViewUp();
}

void pan(vtkCamera& camera, const Vec3& displacement_mm) {
    const Vec3 focus = Vec3(camera.GetFocalPoint()) - displacement_mm;
    const Vec3 eye = Vec3(camera.GetPosition()) - displacement_mm;
    camera.SetFocalPoint(focus.x(), focus.y(), focus.z());
    camera.SetPosition(eye.x(), eye.y(), eye.z());
}

void zoom(vtkCamera& camera, double factor, double closest_mm) {
    const Vec3 focus(camera.GetFocalPoint());
    const Vec3 offset = Vec3(camera.GetPosition()) - focus;
    const double distance = std::max(offset.norm() / factor, closest_mm);
    const Vec3 eye = focus + distance * offset.normalized();
    camera.SetPosition(eye.x(), eye.y(), eye.z());
}

}  // namespace hepatica
