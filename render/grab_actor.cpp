// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/grab_actor.h"

#include <vtkActor.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "render/actor_settings.h"
#include "render/bead.h"

namespace hepatica {

GrabActor::GrabActor()
    : line_source_(vtkSmartPointer<vtkLineSource>::New()),
      line_(vtkSmartPointer<vtkActor>::New()),
      point_(new_bead()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(line_source_->GetOutputPort());
    line_->SetMapper(mapper);
    line_->GetProperty()->SetLighting(false);
    give_colour(*line_, palette::grab_line);
    line_->SetVisibility(false);
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
    point_->SetScale(mm_per_point);
    line_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * pixel_ratio));
}

}  // namespace hepatica
