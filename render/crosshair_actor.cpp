// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/crosshair_actor.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "render/palette.h"

namespace hepatica {

CrosshairActor::CrosshairActor() : actor_(vtkSmartPointer<vtkActor>::New()) {
    constexpr double half_mm = 15.0;
    vtkNew<vtkAppendPolyData> lines;
    for (int axis = 0; axis < 3; ++axis) {
        vtkNew<vtkLineSource> line;
        const Vec3 end = half_mm * Vec3::Unit(axis);
        line->SetPoint1(-end.x(), -end.y(), -end.z());
        line->SetPoint2(end.x(), end.y(), end.z());
        lines->AddInputConnection(line->GetOutputPort());
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(lines->GetOutputPort());
    actor_->SetMapper(mapper);
    const Colour& colour = palette::bridge;
    actor_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor_->GetProperty()->SetLighting(false);
    set_pixel_ratio(1.0);
    actor_->SetVisibility(false);
    actor_->SetPickable(false);
}

void CrosshairActor::set_pixel_ratio(double pixel_ratio) {
    actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixel_ratio));
}

bool CrosshairActor::show(const std::optional<Vec3>& position_mm) {
    if (position_mm == shown_) return false;
    shown_ = position_mm;
    actor_->SetVisibility(position_mm.has_value());
    if (position_mm) actor_->SetPosition(position_mm->x(), position_mm->y(), position_mm->z());
    return true;
}

}  // namespace hepatica
