// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_actor.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <numbers>
#include <sstream>
#include <string>

#include "core/base/three_digits.h"
#include "render/actor_settings.h"
#include "render/bead.h"
#include "render/before_vessels.h"
#include "render/nearest_in_hull.h"
#include "render/palette.h"
#include "render/projection.h"

namespace hepatica {
namespace {

constexpr int around = 32;
constexpr int bands = 8;  // from pole to equator of each hemisphere
constexpr double least_un = 50.0;
constexpr double points_a_decade = 34.0;
constexpr double arrow_width_points = 60.0, shaft_radius = 0.035;  // the latter as its share
// Of the parts that vessels hide: a faint body in a clear outline, bright with a dark edge, so that
// even a small tip is found over vessels and marks of any colour.
constexpr double seen_through = 0.3, outline_seen_through = 0.95;

std::string outlined_ghost() {
    std::ostringstream code;
    code.imbue(std::locale::classic());
    code << std::fixed;
    const auto vec3 = [&code](const Colour& c) {
        code << "vec3(" << c[0] << ", " << c[1] << ", " << c[2] << ")";
    };
    code << R"(//VTK::Light::Impl
  {
    float facing = abs(dot(normalVCVSOutput, normalize(-vertexVC.xyz)));
    float outline = 1.0 - smoothstep(0.60, 0.75, facing);
    float edge = 1.0 - smoothstep(0.25, 0.40, facing);
    vec3 outlined = mix(diffuseColor, )";
    vec3(palette::tool_rim);
    code << ", outline);\n    outlined = mix(outlined, ";
    vec3(palette::rim);
    code << ", edge);\n    gl_FragData[0] = vec4(outlined, mix(" << seen_through << ", "
         << outline_seen_through << ", outline));\n  }\n";
    return code.str();
}

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

// The mean of the contacts, which counts tumours and the liver's wall as well, led to what the jaws
// touch of the vessels.
Vec3 held_place(const ToolView& tool, std::span<const float> positions_mm) {
    std::vector<Vec3> touched;
    for (const int vertex : tool.touched) {
        const std::size_t first = 3 * static_cast<std::size_t>(vertex);
        if (first + 2 < positions_mm.size())
            touched.emplace_back(positions_mm[first], positions_mm[first + 1],
                                 positions_mm[first + 2]);
    }
    return touched.empty() ? tool.at_mm : nearest_in_hull(touched, tool.at_mm);
}

}  // namespace

std::string force_text(double force_un) {
    if (!(force_un >= least_un)) return {};
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.setf(std::ios::fixed);
    text.precision(force_un < 9950.0 ? 1 : 0);
    text << in_three_digits(1e-3 * force_un) << " mN";
    return text.str();
}

ToolActor::ToolActor(vtkRenderer& renderer)
    : renderer_(renderer),
      arrow_(vtkSmartPointer<vtkActor>::New()),
      held_(new_bead()),
      label_(renderer, palette::touch) {
    vtkNew<vtkArrowSource> source;  // from the origin to (1, 0, 0)
    source->SetTipResolution(24);
    source->SetShaftResolution(24);
    source->SetTipLength(0.3);
    source->SetTipRadius(0.09);
    source->SetShaftRadius(shaft_radius);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    arrow_->SetMapper(mapper);
    arrow_->GetProperty()->SetLighting(false);
    give_colour(*arrow_, palette::touch);
    arrow_->SetVisibility(false);
    renderer_.AddActor(arrow_);
    held_->SetPickable(false);
    draw_before_vessels(*held_);
    renderer_.AddActor(held_);
}

ToolActor::~ToolActor() {
    while (!parts_.empty()) remove_part();
    renderer_.RemoveActor(arrow_);
    renderer_.RemoveActor(held_);
}

void ToolActor::add_part() {
    Part part{vtkSmartPointer<vtkActor>::New(), vtkSmartPointer<vtkActor>::New()};
    for (vtkActor* actor : {part.solid.Get(), part.ghost.Get()}) {
        vtkNew<vtkPolyDataMapper> mapper;
        actor->SetMapper(mapper);
        give_colour(*actor, colour_);
    }
    renderer_.AddActor(part.solid);
    part.solid->GetProperty()->SetSpecular(0.5);
    part.solid->GetProperty()->SetSpecularPower(40.0);
    part.ghost->GetProperty()->SetOpacity(seen_through);
    // Blended over what was drawn before it. VTK's pass for translucent surfaces, which sorts them,
    // takes a software renderer as long as the vessels.
    part.ghost->ForceOpaqueOn();
    part.ghost->GetProperty()->BackfaceCullingOn();  // otherwise it would be blended twice
    part.ghost->SetPickable(false);
    draw_before_vessels(*part.ghost);
    part.ghost->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                                  outlined_ghost(), false);
    parts_.push_back(part);
    // Ghosts are added last, because they are in front of everything drawn after them.
    for (const Part& each : parts_) renderer_.RemoveActor(each.ghost);
    for (const Part& each : parts_) renderer_.AddActor(each.ghost);
}

void ToolActor::set_colour(const Colour& colour) {
    colour_ = colour;
    for (const Part& part : parts_)
        for (vtkActor* actor : {part.solid.Get(), part.ghost.Get()}) give_colour(*actor, colour_);
}

void ToolActor::remove_part() {
    renderer_.RemoveActor(parts_.back().solid);
    renderer_.RemoveActor(parts_.back().ghost);
    parts_.pop_back();
}

bool ToolActor::update(const std::optional<ToolView>& tool, std::span<const float> positions_mm) {
    if (tool == shown_) return false;
    shown_ = tool;
    const std::size_t count = tool ? tool->parts.size() : 0;
    while (parts_.size() > count) remove_part();
    while (parts_.size() < count) add_part();
    for (std::size_t p = 0; p < count; ++p) {
        const vtkSmartPointer<vtkPolyData> shape = capsule(tool->parts[p]);
        for (vtkActor* actor : {parts_[p].solid.Get(), parts_[p].ghost.Get()})
            static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(shape);
    }
    const bool holds = tool && !tool->touched.empty() && tool->grip_un >= least_un;
    held_->SetVisibility(holds);
    if (holds) held_->SetPosition(held_place(*tool, positions_mm).data());
    place_arrow();
    return true;
}

void ToolActor::set_scale(double mm_per_point, double pixel_ratio) {
    if (mm_per_point != mm_per_point_) {
        mm_per_point_ = mm_per_point;
        place_arrow();
    }
    held_->SetScale(mm_per_point);
    label_.place(pixel_ratio, 0.0, outlines());
}

std::vector<ThickStretch> ToolActor::outlines() const {
    if (!shown_) return {};
    const int* size = renderer_.GetSize();
    vtkCamera& eye = *renderer_.GetActiveCamera();
    const Projection projection(eye, size[0], size[1]);
    const Vec3 right = axes_of(eye).right;
    const auto pixel_of = [&](const Vec3& place_mm) {
        const Pixel pixel = projection.pixel_of(place_mm);
        return std::array{pixel.x, size[1] - pixel.y};
    };
    std::vector<ThickStretch> all;
    const auto add = [&](const Vec3& from_mm, const Vec3& to_mm, double radius_mm) {
        if (!projection.sees(from_mm) || !projection.sees(to_mm)) return;
        ThickStretch stretch{pixel_of(from_mm), pixel_of(to_mm)};
        stretch.radius = std::max(pixel_of(from_mm + radius_mm * right)[0] - stretch.from[0],
                                  pixel_of(to_mm + radius_mm * right)[0] - stretch.to[0]);
        all.push_back(stretch);
    };
    for (const ToolView::Part& part : shown_->parts) add(part.from_mm, part.to_mm, part.radius_mm);
    if (arrow_->GetVisibility() != 0)
        add(arrow_from_mm_, arrow_to_mm_, shaft_radius * arrow_width_points * mm_per_point_);
    return all;
}

// The arrow starts on the side of the tool away from what presses on it and points along the force.
void ToolActor::place_arrow() {
    const double force_un = shown_ ? shown_->shown_un() : 0.0;
    const double now_un = shown_ ? shown_->force_un.norm() : 0.0;  // gives the direction
    const std::string force = force_text(force_un);
    const std::string grip = shown_ ? force_text(shown_->grip_un) : std::string();
    const bool points = !force.empty() && now_un > 0.0;
    arrow_->SetVisibility(points);
    if (force.empty() && grip.empty()) {
        label_.show({}, {});
        return;
    }
    const std::string text =
        force + (force.empty() || grip.empty() ? "" : ", ") + (grip.empty() ? "" : "grip " + grip);
    if (!points) {
        label_.show(said(words_, text), grip.empty() ? shown_->tip_mm : shown_->at_mm);
        return;
    }
    const Vec3 along = shown_->force_un / now_un;
    const double length = points_a_decade * std::log10(1.0 + 1e-3 * force_un / 0.3) * mm_per_point_;
    const Vec3 from = shown_->at_mm + 2.0 * shown_->parts.front().radius_mm * along;
    const Vec3 u = along.unitOrthogonal(), v = along.cross(u);
    vtkNew<vtkMatrix4x4> place;
    for (int row = 0; row < 3; ++row) {
        place->SetElement(row, 0, length * along[row]);
        place->SetElement(row, 1, arrow_width_points * mm_per_point_ * u[row]);
        place->SetElement(row, 2, arrow_width_points * mm_per_point_ * v[row]);
        place->SetElement(row, 3, from[row]);
    }
    arrow_->SetUserMatrix(place);
    arrow_from_mm_ = from;
    arrow_to_mm_ = from + length * along;
    label_.show(said(words_, text), arrow_to_mm_);
}

}  // namespace hepatica
