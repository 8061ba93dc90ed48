// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/weak_line_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <array>
#include <utility>
#include <vector>

#include "render/palette.h"

namespace hepatica {
namespace {

constexpr float pause = 0.18f;  // share of an edge left free at each of its ends
constexpr double line_points = 4.5;
constexpr double rim_points = 9.0;
constexpr double lift_mm = 1.0;

std::vector<float> dashes_of(const Frame& frame) {
    std::vector<float> ends;
    if (!frame.tear || !frame.tear->weak_edges) return ends;
    const auto& at = frame.positions_mm;
    for (const auto& [a, b] : *frame.tear->weak_edges)
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
            for (std::size_t axis = 0; axis < 3; ++axis)
                ends.push_back((1.0f - pause) * at[3 * static_cast<std::size_t>(from) + axis] +
                               pause * at[3 * static_cast<std::size_t>(to) + axis]);
    return ends;
}

}  // namespace

WeakLineActor::WeakLineActor()
    : dashes_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()),
      rim_(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(dashes_);
    const Colour colour = palette::warning(palette::vessel_system(VascularSystem::unknown), 1.0);
    for (const auto& [actor, of] : {std::pair{actor_.Get(), colour}, {rim_.Get(), palette::rim}}) {
        actor->SetMapper(mapper);
        actor->GetProperty()->SetColor(of[0], of[1], of[2]);
        actor->GetProperty()->SetLighting(false);
        actor->SetVisibility(false);
    }
}

bool WeakLineActor::update(const Frame& frame) {
    std::vector<float> ends = dashes_of(frame);
    if (ends == shown_) return false;
    shown_ = std::move(ends);
    for (vtkActor* actor : actors()) actor->SetVisibility(!shown_.empty());
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t i = 0; i + 5 < shown_.size(); i += 6)
        lines->InsertNextCell(
            {points->InsertNextPoint(&shown_[i]), points->InsertNextPoint(&shown_[i + 3])});
    dashes_->SetPoints(points);
    dashes_->SetLines(lines);
    return true;
}

void WeakLineActor::set_place(const Vec3& to_eye, double pixel_ratio) {
    const auto place = [&](vtkActor& actor, double lifted_mm, double points) {
        const Vec3 lift = lifted_mm * to_eye;
        actor.SetPosition(lift.x(), lift.y(), lift.z());
        actor.GetProperty()->SetLineWidth(static_cast<float>(points * pixel_ratio));
    };
    place(*rim_, 0.9 * lift_mm, rim_points);
    place(*actor_, lift_mm, line_points);
}

}  // namespace hepatica
