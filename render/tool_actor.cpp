// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_actor.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "render/palette.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

constexpr int around = 32;
constexpr int bands = 8;  // of each end, from its pole
constexpr int text_size = 13;
constexpr double least_un = 50.0;
constexpr double points_a_decade = 34.0;
constexpr double edge_pixels = 4.0;  // that stay free beside the label

vtkSmartPointer<vtkPolyData> capsule(const ToolView::Part& part) {
    const Vec3 along = part.to_mm - part.from_mm;
    const Vec3 axis = along.norm() > 0.0 ? along.normalized() : Vec3(Vec3::UnitZ());
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> cells;
    const int rings = 2 * bands + 2;
    for (int r = 0; r < rings; ++r) {
        const bool first_end = r <= bands;
        const double polar =
            0.5 * std::numbers::pi * (first_end ? r - bands : r - bands - 1) / bands;
        const Vec3& middle = first_end ? part.from_mm : part.to_mm;
        for (int i = 0; i <= around; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / around;
            const Vec3 normal = std::sin(polar) * axis +
                                std::cos(polar) * (std::cos(turn) * u + std::sin(turn) * v);
            const Vec3 point = middle + part.radius_mm * normal;
            points->InsertNextPoint(point.data());
            normals->InsertNextTuple(normal.data());
        }
    }
    for (vtkIdType r = 0; r + 1 < rings; ++r)
        for (vtkIdType i = 0; i < around; ++i) {
            const vtkIdType a = r * (around + 1) + i, b = a + around + 1;
            cells->InsertNextCell({a, a + 1, b + 1, b});
        }
    auto polydata = vtkSmartPointer<vtkPolyData>::New();
    polydata->SetPoints(points);
    polydata->SetPolys(cells);
    polydata->GetPointData()->SetNormals(normals);
    return polydata;
}

void give_colour(vtkActor& actor, const Colour& colour) {
    actor.GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

}  // namespace

std::string force_text(double force_un) {
    if (!(force_un >= least_un)) return {};
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.setf(std::ios::fixed);
    text.precision(force_un < 9950.0 ? 1 : 0);
    text << 1e-3 * force_un << " mN";
    return text.str();
}

ToolActor::ToolActor(vtkRenderer& renderer)
    : renderer_(renderer),
      arrow_(vtkSmartPointer<vtkActor>::New()),
      label_(vtkSmartPointer<vtkTextActor>::New()) {
    vtkNew<vtkArrowSource> source;  // from the origin to (1, 0, 0)
    source->SetTipResolution(24);
    source->SetShaftResolution(24);
    source->SetTipLength(0.3);
    source->SetTipRadius(0.09);
    source->SetShaftRadius(0.035);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    arrow_->SetMapper(mapper);
    arrow_->GetProperty()->SetLighting(false);
    give_colour(*arrow_, palette::touch);
    label_->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    for (vtkProp* prop : {static_cast<vtkProp*>(arrow_), static_cast<vtkProp*>(label_)}) {
        prop->SetVisibility(false);
        renderer_.AddActor(prop);
    }
}

ToolActor::~ToolActor() {
    for (const auto& part : parts_) renderer_.RemoveActor(part);
    renderer_.RemoveActor(arrow_);
    renderer_.RemoveActor(label_);
}

bool ToolActor::update(const std::optional<ToolView>& tool) {
    if (tool == shown_) return false;
    shown_ = tool;
    const std::size_t count = tool ? tool->parts.size() : 0;
    while (parts_.size() > count) {
        renderer_.RemoveActor(parts_.back());
        parts_.pop_back();
    }
    while (parts_.size() < count) {
        auto actor = vtkSmartPointer<vtkActor>::New();
        vtkNew<vtkPolyDataMapper> mapper;
        actor->SetMapper(mapper);
        give_colour(*actor, palette::tool);
        actor->GetProperty()->SetSpecular(0.5);
        actor->GetProperty()->SetSpecularPower(40.0);
        renderer_.AddActor(actor);
        parts_.push_back(actor);
    }
    for (std::size_t p = 0; p < count; ++p)
        static_cast<vtkPolyDataMapper*>(parts_[p]->GetMapper())
            ->SetInputData(capsule(tool->parts[p]));
    place_arrow();
    return true;
}

void ToolActor::set_scale(double mm_per_point, double pixel_ratio) {
    style_text(*label_->GetTextProperty(), static_cast<int>(std::lround(text_size * pixel_ratio)),
               palette::touch);
    if (mm_per_point != mm_per_point_) {
        mm_per_point_ = mm_per_point;
        place_arrow();
    }
    place_label();
}

// Beside the arrow's head, but never beyond the picture's edge.
void ToolActor::place_label() {
    if (!label_->GetVisibility()) return;
    vtkNew<vtkCoordinate> head;
    head->SetCoordinateSystemToWorld();
    head->SetValue(head_mm_.x(), head_mm_.y(), head_mm_.z());
    const double* at = head->GetComputedDoubleDisplayValue(&renderer_);
    std::array<double, 2> size{};
    label_->GetSize(&renderer_, size.data());
    const int* picture = renderer_.GetSize();
    std::array<double, 2> place{at[0], at[1]};
    for (int axis = 0; axis < 2; ++axis)
        place[axis] = std::clamp(place[axis], edge_pixels,
                                 std::max(edge_pixels, picture[axis] - size[axis] - edge_pixels));
    label_->GetPositionCoordinate()->SetValue(place[0], place[1]);
}

std::optional<PictureBox> ToolActor::label_box() const {
    if (!label_->GetVisibility()) return std::nullopt;
    std::array<double, 2> size{};
    label_->GetSize(&renderer_, size.data());
    const double* place = label_->GetPosition();
    return PictureBox{place[0], place[1], place[0] + size[0], place[1] + size[1]};
}

// From the tool's other side, away from what presses it.
void ToolActor::place_arrow() {
    const double force_un = shown_ ? shown_->force_un.norm() : 0.0;
    const std::string force = force_text(force_un);
    const std::string grip = shown_ ? force_text(shown_->grip_un) : std::string();
    arrow_->SetVisibility(!force.empty());
    label_->SetVisibility(!force.empty() || !grip.empty());
    if (force.empty() && grip.empty()) return;
    const std::string text =
        force + (force.empty() || grip.empty() ? "" : ", ") + (grip.empty() ? "" : "grip " + grip);
    label_->SetInput((" " + said(words_, text)).c_str());  // beside the arrow's head
    if (force.empty()) {
        head_mm_ = shown_->tip_mm;
        return;
    }
    const Vec3 along = shown_->force_un / force_un;
    const double length = points_a_decade * std::log10(1.0 + 1e-3 * force_un / 0.3) * mm_per_point_;
    const Vec3 from = shown_->at_mm + 2.0 * shown_->parts.front().radius_mm * along;
    const Vec3 u = along.unitOrthogonal(), v = along.cross(u);
    vtkNew<vtkMatrix4x4> place;
    for (int row = 0; row < 3; ++row) {
        place->SetElement(row, 0, length * along[row]);
        place->SetElement(row, 1, 60.0 * mm_per_point_ * u[row]);
        place->SetElement(row, 2, 60.0 * mm_per_point_ * v[row]);
        place->SetElement(row, 3, from[row]);
    }
    arrow_->SetUserMatrix(place);
    head_mm_ = from + length * along;
}

}  // namespace hepatica
