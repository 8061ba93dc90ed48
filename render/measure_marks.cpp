// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure_marks.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/label_places.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

using Place2 = std::array<double, 2>;

}  // namespace

MeasureMarks::MeasureMarks(vtkRenderer& renderer, double width_points)
    : renderer_(renderer),
      width_points_(width_points),
      points_(vtkSmartPointer<vtkPoints>::New()),
      quads_(vtkSmartPointer<vtkCellArray>::New()),
      polydata_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor2D>::New()) {
    polydata_->SetPoints(points_);
    polydata_->SetPolys(quads_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata_);
    actor_->SetMapper(mapper);
    actor_->SetVisibility(false);
    renderer_.AddActor2D(actor_);
}

void MeasureMarks::set_colours(const Colour& lines, const Colour& ground) {
    lines_colour_ = lines;
    ground_colour_ = ground;
    actor_->GetProperty()->SetColor(lines[0], lines[1], lines[2]);
}

bool MeasureMarks::show(std::vector<MeasureView> measures) {
    if (measures == measures_) return false;
    measures_ = std::move(measures);
    return true;
}

// Lines are rectangles, because not every driver draws lines wider than one pixel; points are
// squares.
void MeasureMarks::add_line(const std::vector<Place2>& line, double width, bool ends) {
    const auto add = [&](const std::array<Place2, 4>& corners) {
        std::array<vtkIdType, 4> ids{};
        for (std::size_t c = 0; c < 4; ++c)
            ids[c] = points_->InsertNextPoint(corners[c][0], corners[c][1], 0);
        quads_->InsertNextCell({ids[0], ids[1], ids[2], ids[3]});
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto& [ax, ay] = line[i - 1];
        const auto& [bx, by] = line[i];
        const double length = std::hypot(bx - ax, by - ay);
        if (length < 1e-9) continue;
        const double nx = -0.5 * width * (by - ay) / length, ny = 0.5 * width * (bx - ax) / length;
        add({Place2{ax + nx, ay + ny}, {ax - nx, ay - ny}, {bx - nx, by - ny}, {bx + nx, by + ny}});
    }
    if (!ends) return;
    const double half = 1.3 * width;
    for (const auto& [x, y] : line)
        add({Place2{x - half, y - half},
             {x + half, y - half},
             {x + half, y + half},
             {x - half, y + half}});
}

vtkTextActor& MeasureMarks::next_text(std::size_t used) {
    if (used == texts_.size()) {
        texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
        renderer_.AddActor2D(texts_.back());
    }
    return *texts_[used];
}

void MeasureMarks::part_labels(const std::vector<Place2>& belongs, double point) {
    LabelPlaces places(0.0, renderer_.GetSize()[1]);
    for (std::size_t i = 0; i < belongs.size(); ++i) {
        vtkTextActor& text = *texts_[i];
        std::array<double, 2> size{};
        text.GetSize(&renderer_, size.data());
        const double x = text.GetPosition()[0], wanted = text.GetPosition()[1];
        const double by = std::round(places.place({x, wanted, size[0], size[1]}));
        const double y = wanted + by;
        text.SetPosition(x, y);
        labels_.push_back({x, y, x + size[0], y + size[1]});
        if (by != 0.0) add_line({belongs[i], {x, y + 0.5 * size[1]}}, point, false);
    }
}

void MeasureMarks::update(const Place& place, double point) {
    labels_.clear();
    const bool shown = !measures_.empty();
    actor_->SetVisibility(shown);
    for (const auto& text : texts_) text->SetVisibility(false);
    if (!shown) return;
    points_->Reset();
    quads_->Reset();
    std::vector<Place2> belongs;  // of each text that is used
    for (const MeasureView& measure : measures_) {
        std::vector<Place2> line;
        for (const Vec3& position : measure.points_mm)
            if (const std::optional<Place2> at = place(position)) line.push_back(*at);
        if (line.empty() || line.size() < measure.points_mm.size()) continue;
        add_line(line, width_points_ * point);
        if (measure.text.empty()) continue;
        vtkTextActor& text = next_text(belongs.size());
        belongs.push_back(line.back());
        style_text(*text.GetTextProperty(), static_cast<int>(std::lround(16.0 * point)),
                   lines_colour_);
        // A background keeps the text readable in front of vessels.
        text.GetTextProperty()->SetBackgroundColor(ground_colour_[0], ground_colour_[1],
                                                   ground_colour_[2]);
        text.GetTextProperty()->SetBackgroundOpacity(0.7);
        text.SetInput(measure.text.c_str());
        stand_inside(text, renderer_, std::round(line.back()[0] + 8.0 * point),
                     std::round(line.back()[1] + 6.0 * point));
        text.SetVisibility(true);
    }
    part_labels(belongs, point);
    points_->Modified();
    quads_->Modified();
    polydata_->Modified();
}

}  // namespace hepatica
