// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/depth_stem.h"

#include <vtkActor.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/scene/tools/tool_kinds.h"
#include "render/palette.h"

namespace hepatica {
namespace {

constexpr double touching_mm = 1.0;   // nearer than this, the tool counts as arrived
constexpr double farthest_mm = 80.0;  // beyond this, no distance to the vessels is shown

Vec3 nearest_to(const Vec3& point, const std::vector<float>& positions_mm) {
    Vec3 nearest = point;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 2 < positions_mm.size(); i += 3) {
        const Vec3 place(positions_mm[i], positions_mm[i + 1], positions_mm[i + 2]);
        const double distance = (place - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = place;
    }
    return nearest;
}

// Relative to the viewing direction; empty where the way leads mostly across the picture.
std::string way_in_depth(const Vec3& way_mm, const Vec3& forward) {
    constexpr double hardly = 0.5;  // share of the whole distance
    const double deeper_mm = way_mm.dot(forward);
    if (std::abs(deeper_mm) < hardly * way_mm.norm()) return {};
    return deeper_mm > 0.0 ? " move away from you" : " move towards you";
}

// Half of the widest opening of jaws: what is nearer to their middle lies between them.
double reach_of_jaws_mm(const ToolView& jaws) {
    return 0.5 * jaws_open_to_radii * jaws.parts.front().radius_mm;
}

// The nearest mark that the present step asks for, or of all that are not reached where it asks for
// none.
const MarkView* nearest_waiting(const Vec3& point, const std::vector<MarkView>& marks) {
    const auto farness = [&](const MarkView& mark) {
        return std::pair(!mark.wanted, (mark.place_mm - point).squaredNorm());
    };
    const MarkView* nearest = nullptr;
    for (const MarkView& mark : marks)
        if (mark.of_lesson && !mark.reached &&
            (nearest == nullptr || farness(mark) < farness(*nearest)))
            nearest = &mark;
    return nearest;
}

}  // namespace

DepthStem::DepthStem(vtkRenderer& renderer)
    : renderer_(renderer),
      ends_(vtkSmartPointer<vtkLineSource>::New()),
      line_(vtkSmartPointer<vtkActor>::New()),
      label_(renderer, palette::tool) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ends_->GetOutputPort());
    line_->SetMapper(mapper);
    set_colour(palette::tool);
    line_->GetProperty()->SetLighting(false);
    line_->SetPickable(false);
    line_->SetVisibility(false);
    renderer_.AddActor(line_);
}

DepthStem::~DepthStem() {
    renderer_.RemoveActor(line_);
}

void DepthStem::set_colour(const Colour& colour) {
    line_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

// With the decimals of the lesson's panel, so that no bound looks reached before it is.
std::string DepthStem::words_of(const Vec3& forward) const {
    const std::string mark = !mark_ ? "" : mark_->empty() ? "the mark" : "mark " + *mark_;
    if (between_jaws_) return mark + " is between the jaws";
    const std::string away = fixed_text(away_mm_, mark_ ? 1 : 0) + " mm";
    const std::string way = way_in_depth(end_mm_ - from_mm_, forward);
    if (closed_beside_)
        return "closed " + away + " beside " + mark + ": open with C" +
               (way.empty() ? "" : " and" + way);
    return away + (mark_ ? " to " + mark : "") + (way.empty() ? "" : "," + way);
}

void DepthStem::place(double pixel_ratio, const Vec3& forward,
                      std::span<const ThickStretch> of_tool) {
    constexpr double beside_mark_points = 18.0;
    if (const std::string now = words_of(forward); line_->GetVisibility() != 0 && now != text_) {
        text_ = now;
        label_.show(said(words_, text_), 0.5 * (from_mm_ + end_mm_));
    }
    line_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixel_ratio));
    label_.place(pixel_ratio, beside_mark_points, of_tool);
}

bool DepthStem::update(const std::optional<ToolView>& tool, const std::vector<float>& positions_mm,
                       const std::vector<MarkView>& marks, const Vec3& forward) {
    const bool shown = line_->GetVisibility() != 0;
    double away_mm = 0.0;
    Vec3 end = Vec3::Zero();
    const MarkView* mark = nullptr;
    const bool jaws = tool && tool->has_jaws();
    const Vec3 from = jaws ? tool->working_mm() : tool ? tool->tip_mm : Vec3(Vec3::Zero());
    const bool free = tool && !tool->parts.empty() && tool->touched.empty();
    if (free || jaws) mark = nearest_waiting(from, marks);
    if (free || mark != nullptr) {
        end = mark != nullptr ? mark->place_mm : nearest_to(from, positions_mm);
        away_mm = (end - from).norm();
        // A lesson's goals measure from the same point; vessels are met by the surface of the
        // sphere around it.
        if (mark == nullptr) away_mm -= tool->parts.front().radius_mm;
    }
    const bool at_mark = jaws && mark != nullptr;
    const bool closed = at_mark && tool->closing;
    const bool between = at_mark && !closed && away_mm <= 0.5 * tool->opening_mm;
    const bool held = closed && away_mm <= reach_of_jaws_mm(*tool);
    const bool shows =
        !held &&
        (between || (away_mm >= touching_mm && (mark != nullptr || away_mm <= farthest_mm)));
    line_->SetVisibility(shows);
    if (!shows) return label_.show({}, {}) || shown;
    const bool moved = !shown || from != from_mm_ || end != end_mm_;
    from_mm_ = from;
    end_mm_ = end;
    between_jaws_ = between;
    closed_beside_ = closed;
    away_mm_ = away_mm;
    mark_ = mark != nullptr ? std::optional(mark->number) : std::nullopt;
    const std::string text = words_of(forward);
    if (!moved && text == text_) return false;
    text_ = text;
    ends_->SetPoint1(from_mm_.data());
    ends_->SetPoint2(end_mm_.data());
    label_.show(said(words_, text_), 0.5 * (from_mm_ + end_mm_));
    return true;
}

}  // namespace hepatica
