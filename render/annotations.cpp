// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/annotations.h"

#include <vtkActor2D.h>
#include <vtkCamera.h>
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
#include <numbers>
#include <utility>

#include "core/base/number_text.h"
#include "render/orientation_marker.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

constexpr double margin_pt = 18.0;
constexpr double beside_legend_pt = 10.0;  // between the legend and a text beside it
using std::numbers::pi;

vtkSmartPointer<vtkActor2D> quads_actor(vtkPoints* points, int quads, vtkRenderer& renderer) {
    vtkNew<vtkCellArray> cells;
    for (int q = 0; q < quads; ++q) {
        cells->InsertNextCell({4 * q, 4 * q + 1, 4 * q + 2, 4 * q + 3});
    }
    points->SetNumberOfPoints(4 * quads);
    vtkNew<vtkPolyData> polydata;
    polydata->SetPoints(points);
    polydata->SetPolys(cells);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    renderer.AddActor2D(actor);
    return actor;
}

void set_quad(vtkPoints& points, int quad, double x0, double y0, double x1, double y1) {
    points.SetPoint(4 * quad, x0, y0, 0);
    points.SetPoint(4 * quad + 1, x1, y0, 0);
    points.SetPoint(4 * quad + 2, x1, y1, 0);
    points.SetPoint(4 * quad + 3, x0, y1, 0);
}

vtkSmartPointer<vtkTextActor> text_actor(vtkRenderer& renderer) {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    renderer.AddActor2D(actor);
    return actor;
}

void place_text(vtkTextActor& actor, const std::string& text, double x, double y, double size,
                const Colour& colour) {
    // VTK warns about empty texts, so an empty one is hidden instead.
    actor.SetVisibility(!text.empty());
    if (text.empty()) return;
    style_text(*actor.GetTextProperty(), std::max(6, static_cast<int>(std::lround(size))), colour);
    actor.SetInput(text.c_str());
    actor.SetPosition(std::round(x), std::round(y));
}

}  // namespace

double round_length_below(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    const double leading = length / power;
    return power * (leading >= 5.0 ? 5.0 : leading >= 2.0 ? 2.0 : 1.0);
}

Annotations::Annotations(vtkRenderer& renderer)
    : renderer_(renderer), legend_(renderer), bar_points_(vtkSmartPointer<vtkPoints>::New()) {
    bar_ = quads_actor(bar_points_, 3, renderer);
    bar_label_ = text_actor(renderer);
    bar_label_->GetTextProperty()->SetJustificationToCentered();
    caption_ = text_actor(renderer);
    caption_->GetTextProperty()->SetVerticalJustificationToTop();
    set_look(dark_look);
}

void Annotations::set_look(const ViewLook& look) {
    look_ = look;
    bar_->GetProperty()->SetColor(look.text[0], look.text[1], look.text[2]);
    shown_ = {};  // everything is placed anew
}

void Annotations::set_words(PictureWords words) {
    words_ = std::move(words);
    shown_ = {};
}

bool Annotations::set_caption(const std::string& text) {
    return std::exchange(caption_text_, text) != text;
}

void Annotations::update(const PictureSize& size, vtkCamera& camera, const LegendContent& legend,
                         const Legend::Count& count) {
    Shown now{size.width,
              size.height,
              size.pixel_ratio,
              size.legend_point,
              size.letter_point,
              size.covered_top,
              size.covered_bottom,
              camera.GetDistance(),
              camera.GetViewAngle(),
              visible_,
              legend,
              caption_text_};
    if (now == shown_ && !count) return;
    shown_ = std::move(now);
    write_caption(size);
    legend_.update(visible_ ? legend_rows(legend, words_) : std::vector<LegendRow>{},
                   {size.width, size.height, size.legend_point, caption_width(), size.covered_top,
                    size.covered_bottom, OrientationMarker::right_edge(size),
                    size.covered_bottom + OrientationMarker::right_edge(size)},
                   look_, count, words_);
    if (caption_->GetVisibility()) caption_->SetVisibility(has_room(*caption_, size));
    update_scale_bar(size, camera);
}

// Shortens the caption with an ellipsis where the picture is too narrow for it.
void Annotations::write_caption(const PictureSize& size) {
    const double margin = margin_pt * size.pixel_ratio;
    std::string text = visible_ ? caption_text_ : std::string();
    const auto write = [&](const std::string& shown) {
        place_text(*caption_, shown, margin, size.height - size.covered_top - margin,
                   annotation_letters_pt * size.letter_point, look_.faint_text);
    };
    write(text);
    while (text.size() > 1 && caption_width() > size.width - 2.0 * margin) {
        for (bool whole = false; !whole && !text.empty();) {  // removes one UTF-8 character
            whole = (static_cast<unsigned char>(text.back()) & 0xC0) != 0x80;
            text.pop_back();
        }
        write(text + "…");
    }
}

bool Annotations::shows_caption() const {
    return caption_->GetVisibility() != 0;
}

double Annotations::caption_width() {
    if (!caption_->GetVisibility()) return 0.0;
    double extent[2] = {0.0, 0.0};
    caption_->GetSize(&renderer_, extent);
    return extent[0];
}

bool Annotations::has_room(vtkTextActor& text, const PictureSize& size) {
    double extent[4];  // left, right, bottom, top, relative to its position
    text.GetBoundingBox(&renderer_, extent);
    const double* place = text.GetPosition();
    const PictureBox box{place[0] + extent[0], place[1] + extent[2], place[0] + extent[1],
                         place[1] + extent[3]};
    const double gap = beside_legend_pt * size.letter_point;
    const PictureBox with_gap{box.left - gap, box.bottom, box.right + gap, box.top};
    const bool at_foot = box.bottom < 0.5 * size.height;
    const double left = at_foot ? OrientationMarker::right_edge(size) : 0.0;
    return box.left >= left && box.right <= size.width && !overlap(with_gap, legend_.box());
}

void Annotations::update_scale_bar(const PictureSize& size, vtkCamera& camera) {
    const double r = size.pixel_ratio;
    const double tangent = std::tan(0.5 * camera.GetViewAngle() * pi / 180.0);
    const double mm_per_pixel = 2.0 * camera.GetDistance() * tangent / std::max(size.height, 1);
    const double longest_mm = mm_per_pixel * std::min(140.0 * r, 0.3 * size.width);
    bool shown = visible_ && std::isfinite(longest_mm) && longest_mm > 0.0;
    bar_label_->SetVisibility(shown);
    bar_->SetVisibility(shown);
    if (!shown) return;
    const double length_mm = round_length_below(longest_mm);
    const double width = length_mm / mm_per_pixel;
    const double x = 0.5 * (size.width - width), y = size.covered_bottom + margin_pt * r;
    draw_scale_bar(x, y, width, r);
    const std::string length = fixed_text(length_mm, length_mm < 0.1 ? 2 : length_mm < 1.0 ? 1 : 0);
    // With perspective the bar's length holds only at the depth of the focal point. The label says
    // so, unless the picture is too narrow for it.
    for (const char* unit : {" mm at the depth of the view's centre", " mm"}) {
        place_text(*bar_label_, said(words_, length + unit), 0.5 * size.width, y + 8.0 * r,
                   annotation_letters_pt * size.letter_point, look_.text);
        shown = has_room(*bar_label_, size);
        if (shown) break;
    }
    bar_label_->SetVisibility(shown);
    bar_->SetVisibility(shown);
}

void Annotations::draw_scale_bar(double x, double y, double width, double point) {
    set_quad(*bar_points_, 0, x, y, x + width, y + 1.5 * point);
    set_quad(*bar_points_, 1, x, y, x + 1.5 * point, y + 6.0 * point);
    set_quad(*bar_points_, 2, x + width - 1.5 * point, y, x + width, y + 6.0 * point);
    bar_points_->Modified();
}

}  // namespace hepatica
