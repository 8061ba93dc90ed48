// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mark_actors.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/actor_settings.h"
#include "render/text_style.h"

namespace hepatica {

namespace {

constexpr double radius_points = 13.0;
constexpr double opacity = 0.35;
constexpr int text_size = 19;
constexpr double before_radii = 4.0;  // radii of the sphere that it is moved towards the eye
constexpr double nearest_share =
    0.2;  // least distance of a number from the eye, as a share of the mark's depth

vtkSmartPointer<vtkActor> new_ball() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(28);
    sphere->SetPhiResolution(20);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto ball = vtkSmartPointer<vtkActor>::New();
    ball->SetMapper(mapper);
    ball->GetProperty()->SetOpacity(opacity);
    ball->GetProperty()->SetLighting(false);
    ball->SetPickable(false);
    return ball;
}

}  // namespace

MarkActors::Drawn MarkActors::add_one() {
    Drawn drawn{new_ball(), vtkSmartPointer<vtkBillboardTextActor3D>::New()};
    drawn.number->SetPickable(false);
    renderer_.AddActor(drawn.ball);
    renderer_.AddActor(drawn.number);
    return drawn;
}

bool MarkActors::update(std::vector<MarkView> marks) {
    if (marks == shown_) return false;
    shown_ = std::move(marks);
    for (; drawn_.size() > shown_.size(); drawn_.pop_back()) {
        renderer_.RemoveActor(drawn_.back().ball);
        renderer_.RemoveActor(drawn_.back().number);
    }
    while (drawn_.size() < shown_.size()) drawn_.push_back(add_one());
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
        const MarkView& mark = shown_[i];
        const Colour& colour = mark.reached ? palette::reached : palette::torn_circle;
        give_colour(*drawn_[i].ball, colour);
        const std::string text = mark.number + (mark.reached ? "✓" : "");
        drawn_[i].number->SetInput(text.c_str());
        drawn_[i].number->SetVisibility(!text.empty());
    }
    return true;
}

std::optional<Vec3> MarkActors::place_at(const Projection& projection, const Pixel& pixel,
                                         double times) const {
    std::optional<Vec3> nearest;
    double least_mm = times * ball_mm_;
    for (const MarkView& mark : shown_) {
        if (!mark.of_lesson || mark.reached || !projection.sees(mark.place_mm)) continue;
        const Vec3 beside_it = projection.point_at_depth(pixel, mark.place_mm);
        const double away_mm = (beside_it - mark.place_mm).norm();
        if (away_mm > least_mm) continue;
        least_mm = away_mm;
        nearest = mark.place_mm;
    }
    return nearest;
}

// Horizontal offset of the number in pixels: to the right of the sphere, or to its left near the
// picture's right edge.
int MarkActors::beside(const Vec3& at, const MarkView& mark, double pixel_ratio) const {
    constexpr double widest_letter = 0.9;  // of the letters' height
    const std::size_t letters = mark.number.size() + (mark.reached ? 1 : 0);
    const double away = 0.8 * radius_points * pixel_ratio;
    const double width = widest_letter * text_size * pixel_ratio * static_cast<double>(letters);
    vtkNew<vtkCoordinate> place;
    place->SetCoordinateSystemToWorld();
    place->SetValue(at.x(), at.y(), at.z());
    const double x = place->GetComputedDoubleDisplayValue(&renderer_)[0];
    const bool fits = x + away + width <= renderer_.GetSize()[0];
    return static_cast<int>(std::lround(fits ? away : -away - width));
}

// The point on the line from the eye through the place that lies in front of everything that may
// hide the place, or the place itself.
Vec3 MarkActors::before_all(const Vec3& place_mm, double reach_mm) const {
    vtkCamera& camera = *renderer_.GetActiveCamera();
    const Vec3 eye(camera.GetPosition()), forward(camera.GetDirectionOfProjection());
    const double depth = (place_mm - eye).dot(forward);
    const double nearest = camera.GetDistance() - reach_mm;
    if (depth <= 0.0 || depth <= nearest) return place_mm;
    const double share = std::max(nearest, nearest_share * depth) / depth;
    return eye + share * (place_mm - eye);
}

void MarkActors::set_scale(double mm_per_point, double pixel_ratio, double reach_mm) {
    vtkCamera& camera = *renderer_.GetActiveCamera();
    const Vec3 to_eye = -Vec3(camera.GetDirectionOfProjection()), eye(camera.GetPosition());
    const int away = static_cast<int>(std::lround(0.8 * radius_points * pixel_ratio));
    ball_mm_ = radius_points * mm_per_point;
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
        const Drawn& drawn = drawn_[i];
        const MarkView& mark = shown_[i];
        const Vec3 before = mark.place_mm + before_radii * ball_mm_ * to_eye;
        const Vec3 number = mark.of_lesson ? before_all(mark.place_mm, reach_mm) : before;
        drawn.number->SetPosition(number.x(), number.y(), number.z());
        // A sphere without a number has to be seen by itself.
        const bool alone = mark.of_lesson && mark.number.empty() && !mark.reached;
        const Vec3& ball = alone ? number : mark.of_lesson ? mark.place_mm : before;
        drawn.ball->SetPosition(ball.x(), ball.y(), ball.z());
        // Nearer to the eye it is smaller, so that it looks as large.
        const double away_mm = (mark.place_mm - eye).norm();
        const double share = alone && away_mm > 0.0 ? (ball - eye).norm() / away_mm : 1.0;
        drawn.ball->SetScale(share * ball_mm_);
        if (!mark.of_lesson) give_colour(*drawn.ball, text_colour_);
        style_text(*drawn.number->GetTextProperty(),
                   static_cast<int>(std::lround(text_size * pixel_ratio)), text_colour_);
        drawn.number->GetTextProperty()->SetBold(true);
        drawn.number->SetDisplayOffset(beside(number, mark, pixel_ratio), away);
    }
}

}  // namespace hepatica
