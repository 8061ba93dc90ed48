// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure_marks.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/palette.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

using Place2 = std::array<double, 2>;

constexpr std::array<unsigned char, 3> shadow{0, 0, 0};

std::array<unsigned char, 3> bytes_of(const Colour& colour) {
    std::array<unsigned char, 3> bytes{};
    for (std::size_t c = 0; c < 3; ++c)
        bytes[c] = static_cast<unsigned char>(std::lround(255.0 * colour[c]));
    return bytes;
}

}  // namespace

MeasureMarks::MeasureMarks(vtkRenderer& renderer)
    : renderer_(renderer),
      points_(vtkSmartPointer<vtkPoints>::New()),
      quads_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      polydata_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor2D>::New()) {
    colours_->SetNumberOfComponents(3);
    polydata_->SetPoints(points_);
    polydata_->SetPolys(quads_);
    polydata_->GetCellData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata_);
    actor_->SetMapper(mapper);
    actor_->SetVisibility(false);
    renderer_.AddActor2D(actor_);
}

bool MeasureMarks::show(std::vector<MeasureView> measures) {
    if (measures == measures_) return false;
    measures_ = std::move(measures);
    return true;
}

// Of rectangles, because not every driver draws lines wider than a pixel; a point is a square.
void MeasureMarks::add_line(const std::vector<Place2>& line, double width,
                            const std::array<unsigned char, 3>& colour) {
    const auto add = [&](const std::array<Place2, 4>& corners) {
        std::array<vtkIdType, 4> ids{};
        for (std::size_t c = 0; c < 4; ++c)
            ids[c] = points_->InsertNextPoint(corners[c][0], corners[c][1], 0);
        quads_->InsertNextCell({ids[0], ids[1], ids[2], ids[3]});
        for (const unsigned char channel : colour) colours_->InsertNextValue(channel);
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto& [ax, ay] = line[i - 1];
        const auto& [bx, by] = line[i];
        const double length = std::hypot(bx - ax, by - ay);
        if (length < 1e-9) continue;
        const double nx = -0.5 * width * (by - ay) / length, ny = 0.5 * width * (bx - ax) / length;
        add({Place2{ax + nx, ay + ny}, {ax - nx, ay - ny}, {bx - nx, by - ny}, {bx + nx, by + ny}});
    }
    const double half = 1.3 * width;
    for (const auto& [x, y] : line)
        add({Place2{x - half, y - half},
             {x + half, y - half},
             {x + half, y + half},
             {x - half, y + half}});
}

void MeasureMarks::update(const Place& place, double point) {
    const bool shown = !measures_.empty();
    actor_->SetVisibility(shown);
    for (const auto& text : texts_) text->SetVisibility(false);
    if (!shown) return;
    points_->Reset();
    quads_->Reset();
    colours_->Reset();
    std::size_t used = 0;
    for (const MeasureView& measure : measures_) {
        std::vector<Place2> line;
        for (const Vec3& position : measure.points_mm) line.push_back(place(position));
        if (line.empty()) continue;
        add_line(line, 3.6 * point, shadow);
        add_line(line, 1.8 * point, bytes_of(palette::measure));
        if (measure.text.empty()) continue;
        if (used == texts_.size()) {
            texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
            renderer_.AddActor2D(texts_.back());
        }
        vtkTextActor& text = *texts_[used++];
        style_text(*text.GetTextProperty(), static_cast<int>(std::lround(16.0 * point)),
                   palette::measure);
        // Readable before vessels and light backgrounds alike.
        text.GetTextProperty()->SetBackgroundColor(0.0, 0.0, 0.0);
        text.GetTextProperty()->SetBackgroundOpacity(0.6);
        text.SetInput(measure.text.c_str());
        text.SetPosition(std::round(line.back()[0] + 8.0 * point),
                         std::round(line.back()[1] + 6.0 * point));
        text.SetVisibility(true);
    }
    points_->Modified();
    quads_->Modified();
    colours_->Modified();
    polydata_->Modified();
}

}  // namespace hepatica
