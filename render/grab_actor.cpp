// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/grab_actor.h"

#include <vtkActor.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "render/palette.h"

namespace hepatica {

GrabActor::GrabActor()
    : line_source_(vtkSmartPointer<vtkLineSource>::New()),
      line_(vtkSmartPointer<vtkActor>::New()),
      point_(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> line_mapper;
    line_mapper->SetInputConnection(line_source_->GetOutputPort());
    line_->SetMapper(line_mapper);
    vtkNew<vtkSphereSource> bead;
    bead->SetRadius(1.0);
    bead->SetThetaResolution(20);
    bead->SetPhiResolution(14);
    vtkNew<vtkPolyDataMapper> bead_mapper;
    bead_mapper->SetInputConnection(bead->GetOutputPort());
    point_->SetMapper(bead_mapper);
    const Colour& colour = palette::grab_line;
    for (vtkActor* actor : {line_.Get(), point_.Get()}) {
        actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
        actor->GetProperty()->SetLighting(false);
        actor->SetVisibility(false);
    }
    set_scale(1.0, 1.0);
}

bool GrabActor::update(const std::optional<GrabView>& grab) {
    const bool same =
        grab.has_value() == shown_.has_value() &&
        (!grab || (grab->point_mm == shown_->point_mm && grab->target_mm == shown_->target_mm));
    if (same) return false;
    shown_ = grab;
    line_->SetVisibility(grab.has_value());
    point_->SetVisibility(grab.has_value());
    if (!grab) return true;
    line_source_->SetPoint1(grab->point_mm.data());
    line_source_->SetPoint2(grab->target_mm.data());
    point_->SetPosition(grab->target_mm.x(), grab->target_mm.y(), grab->target_mm.z());
    return true;
}

void GrabActor::set_scale(double mm_per_point, double pixel_ratio) {
    point_->SetScale(4.0 * mm_per_point);
    line_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * pixel_ratio));
}

}  // namespace hepatica
