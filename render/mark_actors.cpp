// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mark_actors.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "render/palette.h"

namespace hepatica {

namespace {

constexpr double radius_points = 13.0;
constexpr double opacity = 0.35;

vtkSmartPointer<vtkActor> new_ball() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(28);
    sphere->SetPhiResolution(20);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto ball = vtkSmartPointer<vtkActor>::New();
    ball->SetMapper(mapper);
    const Colour& colour = palette::torn_circle;
    ball->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    ball->GetProperty()->SetOpacity(opacity);
    ball->GetProperty()->SetLighting(false);
    ball->SetPickable(false);
    return ball;
}

}  // namespace

bool MarkActors::update(const std::vector<Vec3>& places_mm) {
    if (places_mm == shown_) return false;
    shown_ = places_mm;
    for (; balls_.size() > places_mm.size(); balls_.pop_back())
        renderer_.RemoveActor(balls_.back());
    while (balls_.size() < places_mm.size()) {
        balls_.push_back(new_ball());
        renderer_.AddActor(balls_.back());
    }
    for (std::size_t i = 0; i < balls_.size(); ++i)
        balls_[i]->SetPosition(places_mm[i].x(), places_mm[i].y(), places_mm[i].z());
    return true;
}

void MarkActors::set_scale(double mm_per_point) {
    for (const auto& ball : balls_) ball->SetScale(radius_points * mm_per_point);
}

}  // namespace hepatica
