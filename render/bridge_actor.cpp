// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bridge_actor.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <utility>

#include "render/before_vessels.h"
#include "render/palette.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

constexpr double dash_mm = 1.2;
constexpr double pause_mm = 0.8;
constexpr double radius_mm = 0.35;
constexpr double chosen_radius_mm = 0.6;
constexpr int text_size = 13;

double length_of(const std::vector<Vec3>& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
    return length;
}

Vec3 point_along(const std::vector<Vec3>& path, double along) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double step = (path[i] - path[i - 1]).norm();
        if (along <= step && step > 0.0)
            return path[i - 1] + along / step * (path[i] - path[i - 1]);
        along -= step;
    }
    return path.back();
}

// Straight dashes of `dash_mm` along the path, `pause_mm` apart.
vtkSmartPointer<vtkPolyData> dashes(const std::vector<Vec3>& path) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    const double length = length_of(path);
    for (double from = 0.0; from < length; from += dash_mm + pause_mm) {
        const Vec3 a = point_along(path, from);
        const Vec3 b = point_along(path, std::min(from + dash_mm, length));
        lines->InsertNextCell(
            {points->InsertNextPoint(a.data()), points->InsertNextPoint(b.data())});
    }
    auto polydata = vtkSmartPointer<vtkPolyData>::New();
    polydata->SetPoints(points);
    polydata->SetLines(lines);
    return polydata;
}

}  // namespace

std::vector<BridgeView> views_of(const std::vector<Bridge>& bridges) {
    std::vector<BridgeView> views;
    for (const Bridge& bridge : bridges)
        views.push_back({bridge.path_mm,
                         std::to_string(std::lround(100.0 * bridge.confidence)) + " %", false,
                         0.0});
    return views;
}

BridgeActor::BridgeActor(vtkRenderer& renderer) : renderer_(renderer) {}

BridgeActor::~BridgeActor() {
    remove_actors();
}

void BridgeActor::remove_actors() {
    for (const auto& line : lines_) renderer_.RemoveActor(line);
    for (const auto& label : labels_) renderer_.RemoveActor(label);
    lines_.clear();
    labels_.clear();
}

void BridgeActor::set_bridges(std::vector<BridgeView> bridges) {
    remove_actors();
    bridges_ = std::move(bridges);
    for (const BridgeView& bridge : bridges_) {
        const Colour& colour = bridge.chosen ? text_colour_ : palette::bridge;
        // Tubes, because not every driver draws lines wider than one pixel.
        vtkNew<vtkTubeFilter> rods;
        rods->SetInputData(dashes(bridge.path_mm));
        rods->SetRadius((bridge.chosen ? chosen_radius_mm : radius_mm) + bridge.around_mm);
        rods->SetNumberOfSides(8);
        rods->CappingOn();
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(rods->GetOutputPort());
        vtkNew<vtkActor> line;
        line->SetMapper(mapper);
        line->GetProperty()->SetLighting(false);
        line->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
        // Hidden by vessels it would not be found.
        if (bridge.chosen) draw_before_vessels(*line);
        renderer_.AddActor(line);
        lines_.emplace_back(line);

        vtkNew<vtkBillboardTextActor3D> label;
        label->SetInput(said(words_, bridge.label).c_str());
        const Vec3 middle = point_along(bridge.path_mm, 0.5 * length_of(bridge.path_mm));
        label->SetPosition(middle.x(), middle.y(), middle.z());
        renderer_.AddActor(label);
        labels_.emplace_back(label);
    }
    set_pixel_ratio(pixel_ratio_);
}

void BridgeActor::set_text_colour(const Colour& colour) {
    text_colour_ = colour;
    set_bridges(bridges_);
}

void BridgeActor::set_pixel_ratio(double pixel_ratio) {
    pixel_ratio_ = pixel_ratio;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const bool chosen = bridges_[i].chosen;
        style_text(*labels_[i]->GetTextProperty(),
                   static_cast<int>(std::lround(text_size * pixel_ratio)),
                   chosen ? text_colour_ : palette::bridge);
        const int away = static_cast<int>(std::lround(6.0 * pixel_ratio));
        labels_[i]->SetDisplayOffset(away, away);
    }
}

}  // namespace hepatica
