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
constexpr double line_points = 3.5;
constexpr double rim_points = 7.0;
constexpr double line_lift_mm = 1.0, rim_lift_mm = 0.9;

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

WeakLineActor::WeakLineActor() {
    for (const auto& [ribbons, of] :
         {std::pair<Ribbons&, Colour>{rim_, palette::rim}, {line_, palette::weak_line()}}) {
        ribbons.quads = vtkSmartPointer<vtkPolyData>::New();
        ribbons.actor = vtkSmartPointer<vtkActor>::New();
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(ribbons.quads);
        ribbons.actor->SetMapper(mapper);
        ribbons.actor->GetProperty()->SetColor(of[0], of[1], of[2]);
        ribbons.actor->GetProperty()->SetLighting(false);
        ribbons.actor->SetVisibility(false);
    }
}

bool WeakLineActor::update(const Frame& frame) {
    std::vector<float> ends = dashes_of(frame);
    if (ends == shown_) return false;
    shown_ = std::move(ends);
    for (vtkActor* actor : actors()) actor->SetVisibility(!shown_.empty());
    return true;
}

void WeakLineActor::set_place(const Vec3& to_eye, double mm_per_point) {
    if (shown_.empty()) return;
    rim_.lay(shown_, to_eye, rim_points * mm_per_point, rim_lift_mm);
    line_.lay(shown_, to_eye, line_points * mm_per_point, line_lift_mm);
}

// As much longer at its ends as it is wider.
void WeakLineActor::Ribbons::lay(const std::vector<float>& ends, const Vec3& to_eye, double wide_mm,
                                 double lift_mm) const {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (std::size_t i = 0; i + 5 < ends.size(); i += 6) {
        const Vec3 from(ends[i], ends[i + 1], ends[i + 2]);
        const Vec3 to(ends[i + 3], ends[i + 4], ends[i + 5]);
        const Vec3 across = to_eye.cross(to - from);
        if (across.norm() < 1e-9) continue;  // seen end on
        const Vec3 half = 0.5 * wide_mm * across.normalized();
        const Vec3 longer = 0.5 * wide_mm * half.cross(to_eye).normalized();
        std::array<vtkIdType, 4> ids{};
        std::size_t next = 0;
        for (const Vec3& corner : {Vec3(from - longer + half), Vec3(from - longer - half),
                                   Vec3(to + longer - half), Vec3(to + longer + half)}) {
            const Vec3 at = corner + lift_mm * to_eye;
            ids[next++] = points->InsertNextPoint(at.x(), at.y(), at.z());
        }
        cells->InsertNextCell(4, ids.data());
    }
    quads->SetPoints(points);
    quads->SetPolys(cells);
}

}  // namespace hepatica
