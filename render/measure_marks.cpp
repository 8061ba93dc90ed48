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

#include "render/text_style.h"

namespace hepatica {
namespace {

using Place2 = std::array<double, 2>;

constexpr double width_pt = 2.0;  // of lines
constexpr double letters_pt = 16.0;
constexpr double least_shrunk_letters = 0.6;
// To the picture's edge, where a window may draw its frame: 4 pixels, 8 on a dense screen.
constexpr double edge_pt = 0.3 * letters_pt;

}  // namespace

MeasureMarks::MeasureMarks(vtkRenderer& renderer)
    : renderer_(renderer),
      points_(vtkSmartPointer<vtkPoints>::New()),
      quads_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      polydata_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor2D>::New()) {
    polydata_->SetPoints(points_);
    polydata_->SetPolys(quads_);
    colours_->SetNumberOfComponents(3);
    polydata_->GetCellData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata_);
    actor_->SetMapper(mapper);
    actor_->SetVisibility(false);
    renderer_.AddActor2D(actor_);
}

void MeasureMarks::set_colours(const Colour& lines, const Colour& ground) {
    lines_colour_ = lines;
    ground_colour_ = ground;
}

bool MeasureMarks::show(std::vector<MeasureView> measures) {
    if (measures == measures_) return false;
    measures_ = std::move(measures);
    return true;
}

void MeasureMarks::add_band(const Place2& from, const Place2& to, double low, double high,
                            const Colour& colour) {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 1e-9) return;
    const double left_x = -(to[1] - from[1]) / length, left_y = (to[0] - from[0]) / length;
    const auto corner = [&](const Place2& at, double aside) {
        return points_->InsertNextPoint(at[0] + aside * left_x, at[1] + aside * left_y, 0);
    };
    quads_->InsertNextCell(
        {corner(from, low), corner(to, low), corner(to, high), corner(from, high)});
    for (const double channel : colour)
        colours_->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * channel)));
}

// Lines are rectangles, because not every driver draws lines wider than one pixel; points are
// squares. Rims lie beside the line and end before the squares: which of two things that overlap is
// in front depends on the driver.
void MeasureMarks::add_line(const std::vector<Place2>& line, double width, bool whole) {
    const double inner = 0.5 * width, outer = width, before_square = 2.0 * width;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto& [ax, ay] = line[i - 1];
        const auto& [bx, by] = line[i];
        add_band(line[i - 1], line[i], -inner, inner, lines_colour_);
        const double length = std::hypot(bx - ax, by - ay);
        if (!whole || length <= 2.0 * before_square) continue;
        const double x = before_square * (bx - ax) / length;
        const double y = before_square * (by - ay) / length;
        const Place2 from{ax + x, ay + y}, to{bx - x, by - y};
        add_band(from, to, -outer, -inner, ground_colour_);
        add_band(from, to, inner, outer, ground_colour_);
    }
    if (!whole) return;
    const double half = 1.3 * width;
    for (const auto& [x, y] : line)
        add_band({x - half, y}, {x + half, y}, -half, half, lines_colour_);
}

vtkTextActor& MeasureMarks::next_text(std::size_t used) {
    if (used == texts_.size()) {
        texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
        renderer_.AddActor2D(texts_.back());
    }
    return *texts_[used];
}

std::array<double, 2> MeasureMarks::fit(vtkTextActor& text, double widest, double point) {
    int letters = static_cast<int>(std::lround(letters_pt * point));
    const int least = static_cast<int>(std::lround(least_shrunk_letters * letters));
    for (;;) {
        style_text(*text.GetTextProperty(), letters, lines_colour_);
        std::array<double, 2> size{};
        text.GetSize(&renderer_, size.data());
        if (size[0] <= widest || letters <= least) return size;
        const int fitting = static_cast<int>(letters * widest / size[0]);
        letters = std::clamp(fitting, least, letters - 1);
    }
}

void MeasureMarks::place_labels(const std::vector<Place2>& belongs, const LabelBox& room,
                                const PictureBox& legend, double point) {
    LabelPlaces places(room);
    if (legend.right > legend.left)
        places.keep_off(
            {legend.left, legend.bottom, legend.right - legend.left, legend.top - legend.bottom});
    for (std::size_t i = 0; i < belongs.size(); ++i) {
        vtkTextActor& text = *texts_[i];
        const auto& [x, y] = belongs[i];
        const auto [width, height] = fit(text, room.width, point);
        const auto label = places.place({x + 8.0 * point, y + 6.0 * point, width, height});
        text.SetVisibility(label.has_value());
        if (!label) continue;
        const double left = std::round(label->box.left), bottom = std::round(label->box.top);
        text.SetPosition(left, bottom);
        labels_.push_back({left, bottom, left + width, bottom + height});
        if (label->evades)
            add_line({belongs[i],
                      {std::clamp(x, left, left + width), std::clamp(y, bottom, bottom + height)}},
                     point, false);
    }
}

void MeasureMarks::update(const Place& place, double point, double covered_top,
                          double covered_bottom, const PictureBox& legend) {
    labels_.clear();
    const bool shown = !measures_.empty();
    actor_->SetVisibility(shown);
    for (const auto& text : texts_) text->SetVisibility(false);
    if (!shown) return;
    points_->Reset();
    quads_->Reset();
    colours_->Reset();
    std::vector<Place2> belongs;  // of each text that is used
    for (const MeasureView& measure : measures_) {
        std::vector<Place2> line;
        for (const Vec3& position : measure.points_mm)
            if (const std::optional<Place2> at = place(position)) line.push_back(*at);
        if (line.empty() || line.size() < measure.points_mm.size()) continue;
        add_line(line, width_pt * point);
        if (measure.text.empty()) continue;
        vtkTextActor& text = next_text(belongs.size());
        belongs.push_back(line.back());
        // A background keeps the text readable in front of vessels.
        text.GetTextProperty()->SetBackgroundColor(ground_colour_[0], ground_colour_[1],
                                                   ground_colour_[2]);
        text.GetTextProperty()->SetBackgroundOpacity(0.7);
        text.SetInput(measure.text.c_str());
    }
    const double edge = edge_pt * point;
    const int* picture = renderer_.GetSize();
    place_labels(belongs,
                 {edge, covered_bottom + edge, picture[0] - 2.0 * edge,
                  picture[1] - covered_top - covered_bottom - 2.0 * edge},
                 legend, point);
    points_->Modified();
    quads_->Modified();
    colours_->Modified();
    polydata_->Modified();
}

}  // namespace hepatica
