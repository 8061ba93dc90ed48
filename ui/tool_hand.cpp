// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/frame_time.h"
#include "ui/pointed_place.h"

namespace hepatica {
namespace {

constexpr double least_notch_mm = 0.5;
// Beside the vessels a mark is meant also a little beside its sphere.
constexpr double spheres_beside_mark = 1.6;
// Each try comes nearer to the user, where less is in the way.
constexpr int tries_at_mouse = 6;

bool has_shape_of(const ToolView& a, const ToolView& b) {
    constexpr double rounding_mm = 1e-3;
    return std::ranges::equal(a.parts, b.parts, [](const auto& one, const auto& other) {
        const double longer_mm = one.along_mm().norm() - other.along_mm().norm();
        return one.radius_mm == other.radius_mm && std::abs(longer_mm) <= rounding_mm;
    });
}

// Direction of an instrument: from the lower right into the picture.
Vec3 way_of_instrument(const ViewAxes& axes) {
    return (0.5 * axes.forward - 0.62 * axes.right + 0.6 * axes.up).normalized();
}

// Direction of jaws that are to hold a vessel: into the picture, leaning along the vessel.
Vec3 way_to_take(const ViewAxes& axes, const Vec3& vessel) {
    const Vec3 seen = vessel - vessel.dot(axes.forward) * axes.forward;
    if (seen.norm() < 0.1) return way_of_instrument(axes);
    const Vec3 along = (seen.dot(axes.right - axes.up) < 0.0 ? -seen : seen).normalized();
    return 0.8 * axes.forward - 0.6 * along;
}

// Direction in which jaws open and a hook points: perpendicular to the instrument in the picture,
// towards the top.
Vec3 side_in_picture(const ViewAxes& axes, const Vec3& direction) {
    const Vec3 across = axes.forward.cross(direction);
    const Vec3 side = across.isZero(1e-6) ? axes.right : Vec3(across.normalized());
    return side.dot(axes.up) < 0.0 ? Vec3(-side) : side;
}

}  // namespace

std::optional<double> at_least(double left_s, std::optional<double> over_s) {
    return left_s < frame_s ? over_s : std::max(over_s.value_or(0.0), left_s);
}

ToolHand::ToolHand(SceneView& view, std::function<void(Command)> post,
                   VesselDirection vessel_direction)
    : view_(view), post_(std::move(post)), vessel_direction_(std::move(vessel_direction)) {}

void ToolHand::take(const std::string& kind) {
    if (kind_.empty()) post_(UseTools{true});
    kind_ = kind;
    asked_ = false;
    if (seen_) {
        // A tool that was there keeps its place.
        const Vec3 place = seen_->working_mm();
        more_tries_ = tries_at_mouse;
        return bring(place, way_at(view_.pixel_of(place)));
    }
    if (mouse_at_) bring_to(*mouse_at_);
}

void ToolHand::forget() {
    kind_.clear();
    seen_.reset();
    replaced_.reset();
    asked_ = false;
    mouse_at_.reset();
}

void ToolHand::put_away() {
    if (kind_.empty()) return;
    forget();
    post_(RemoveTool{});
    post_(UseTools{false});
}

void ToolHand::set_size(const ToolSize& size) {
    size_ = size;
    more_tries_ = 0;  // the mouse is at the panel
    if (seen_) bring(seen_->working_mm(), present_way());
}

Vec3 ToolHand::present_way() const {
    const ToolView::Part& part = seen_->parts.front();
    const Vec3 along = part.to_mm - part.from_mm;
    if (kind_ == "sphere") return view_.axes().forward;
    return along.isZero(0.0) ? way_of_instrument(view_.axes()) : Vec3(along.normalized());
}

// A frame from before the new tool came shows the old one. The new one has another shape, or is
// nearer to its place.
bool ToolHand::is_still_the_old(const ToolView& tool) {
    if (!replaced_ || !has_shape_of(tool, replaced_->tool)) return false;
    if (!replaced_->reshaped) {
        const Vec3 old_mm = replaced_->tool.working_mm(), now_mm = tool.working_mm();
        const double before_mm = (old_mm - replaced_->place_mm).norm();
        const double left_mm = (now_mm - replaced_->place_mm).norm();
        const bool elsewhere = replaced_->rested && (now_mm - old_mm).norm() > least_notch_mm;
        if (elsewhere || before_mm <= least_notch_mm || left_mm <= 0.7 * before_mm) return false;
    }
    return --replaced_->frames > 0;
}

bool ToolHand::bring_again() {
    if (!mouse_at_ || more_tries_ == 0) return false;
    const Vec3 place = view_.point_at_depth(*mouse_at_, seen_->working_mm());
    if ((place - seen_->working_mm()).norm() <= 2.0 * size_.radius_mm) return false;
    --more_tries_;
    bring(place, present_way());
    replaced_->rested = true;
    return true;
}

void ToolHand::follow(const std::optional<ToolView>& tool) {
    if (kind_.empty()) return;
    if (tool && !seen_ && is_still_the_old(*tool)) return;
    const bool comes = tool && !seen_;
    if (tool || seen_) asked_ = false;
    seen_ = tool;
    if (comes) {
        replaced_.reset();
        if (bring_again()) return;
        depth_mm_ = tool->working_mm();
        depth_asked_mm_ = 0.0;
    }
    if (!tool || kind_ != "forceps") return;
    const GripWatch::Seen seen = grip_.see(*tool, closed_);
    if (seen == GripWatch::Seen::closed_on_nothing || seen == GripWatch::Seen::slipped)
        on_empty_grip(seen);
}

void ToolHand::begin_again() {
    seen_.reset();
    replaced_.reset();
    asked_ = false;
    if (!kind_.empty()) post_(UseTools{true});
}

void ToolHand::move(const Pixel& at) {
    mouse_at_ = at;
    if (kind_.empty()) return;
    if (!seen_) {
        if (!asked_) bring_to(at);
        return;
    }
    lead_to(at, pace_.heard(HandPace::Clock::now()));
}

// Before the depth is reached a report of the mouse takes no less time than is left for that.
void ToolHand::lead_to(const Pixel& at, std::optional<double> over_s) {
    const Vec3 by = view_.point_at_depth(at, depth_mm_) - seen_->working_mm();
    double left_s = depth_asked_mm_ > 0.0
                        ? wheel_over_s * std::min(1.0, depth_left_mm() / depth_asked_mm_)
                        : 0.0;
    if (by.norm() > usual_lag_mm)
        left_s = std::clamp(by.norm() / fastest_lead_mm_per_s, left_s, longest_move_s);
    post_(MoveTool{.target_mm = seen_->centre_mm + by, .over_s = at_least(left_s, over_s)});
}

double ToolHand::depth_left_mm() const {
    return std::abs((depth_mm_ - seen_->working_mm()).dot(view_.axes().forward));
}

void ToolHand::press(const Pixel& at) {
    if (!kind_.empty() && !seen_) bring_to(at);
}

bool ToolHand::click(const Pixel& at) {
    if (!seen_ || closed_ || !seen_->touched.empty()) return false;
    const std::optional<Vec3> place = place_at(at);
    if (!place) return false;
    const double away_mm = (*place - seen_->working_mm()).dot(view_.axes().forward);
    if (std::abs(away_mm) <= 2.0 * size_.radius_mm || !may_bring()) return false;
    more_tries_ = tries_at_mouse;
    bring(*place, present_way());
    return true;
}

void ToolHand::shift_depth(double steps) {
    if (!seen_) return;
    depth_mm_ += steps * std::max(least_notch_mm, 0.5 * size_.radius_mm) * view_.axes().forward;
    depth_asked_mm_ = depth_left_mm();
    if (mouse_at_) lead_to(*mouse_at_, std::nullopt);
}

void ToolHand::turn(double angle_rad) {
    if (seen_ && kind_ != "sphere") post_(TurnTool{-angle_rad * view_.axes().forward});
}

void ToolHand::close_or_open() {
    if (!seen_ || kind_ != "forceps") return;
    post_(closed_ ? Command(OpenForceps{}) : Command(CloseForceps{}));
    closed_ = !closed_;
}

// Direction of a new tool: forceps and hooks are aligned with the vessel at this pixel.
Vec3 ToolHand::way_at(const Pixel& at) const {
    if (kind_ == "sphere") return view_.ray_through(at).direction;
    const SurfacePick pick = view_.pick(at);
    const bool takes = kind_ == "forceps" || kind_ == "hook";
    const Vec3 vessel = pick.triangle >= 0 && takes ? vessel_direction_(pick) : Vec3(Vec3::Zero());
    return way_to_take(view_.axes(), vessel);
}

std::optional<Vec3> ToolHand::place_at(const Pixel& at) const {
    return pointed_place(view_, at, view_.pick(at), spheres_beside_mark);
}

// Where nothing is pointed at, at the depth of the camera's focus.
void ToolHand::bring_to(const Pixel& at) {
    std::optional<Vec3> place = place_at(at);
    if (place && !may_bring()) place.reset();
    more_tries_ = tries_at_mouse;
    bring(place ? *place : view_.point_at_depth(at, view_.axes().focus_mm), way_at(at));
}

void ToolHand::bring(const Vec3& place_mm, const Vec3& direction) {
    const double length_mm = kind_ == "sphere" ? 0.0 : size_.length_mm;
    AddTool tool{kind_, size_.radius_mm, length_mm, direction, place_mm};
    if (kind_ == "forceps" || kind_ == "hook") tool.side = side_in_picture(view_.axes(), direction);
    post_(tool);
    if (seen_) replaced_ = Replaced{*seen_, added_};
    if (replaced_) {  // also where no frame has shown the tool before this one
        const AddTool& old = replaced_->added;
        const bool reshaped = old.kind != tool.kind || old.radius_mm != tool.radius_mm ||
                              old.length_mm != tool.length_mm;
        replaced_ = Replaced{replaced_->tool, old, place_mm, reshaped};
    }
    added_ = tool;
    seen_.reset();
    closed_ = false;
    asked_ = true;
}

}  // namespace hepatica
