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

// Relative to the viewing direction.
std::string way_to_mark(const std::string& number, double deeper_mm, double away_mm) {
    constexpr double hardly = 0.5;  // share of the whole distance
    const std::string to = number.empty() ? " to the mark" : " to mark " + number;
    if (std::abs(deeper_mm) < hardly * away_mm) return to;
    return to + (deeper_mm > 0.0 ? ", move away from you" : ", move towards you");
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
    if (between_jaws_)
        return (mark_->empty() ? "the mark" : "mark " + *mark_) + " is between the jaws";
    const std::string away = fixed_text(away_mm_, mark_ ? 1 : 0) + " mm";
    return mark_ ? away + way_to_mark(*mark_, (end_mm_ - from_mm_).dot(forward), away_mm_) : away;
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
    if (free || (jaws && tool->grip_un <= 0.0)) mark = nearest_waiting(from, marks);
    if (free || mark != nullptr) {
        end = mark != nullptr ? mark->place_mm : nearest_to(from, positions_mm);
        away_mm = (end - from).norm();
        // A lesson's goals measure from the same point; vessels are met by the surface of the
        // sphere around it.
        if (mark == nullptr) away_mm -= tool->parts.front().radius_mm;
    }
    const bool between = jaws && mark != nullptr && away_mm <= 0.5 * tool->opening_mm;
    const bool shows =
        between || (away_mm >= touching_mm && (mark != nullptr || away_mm <= farthest_mm));
    line_->SetVisibility(shows);
    if (!shows) return label_.show({}, {}) || shown;
    const bool moved = !shown || from != from_mm_ || end != end_mm_;
    from_mm_ = from;
    end_mm_ = end;
    between_jaws_ = between;
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
