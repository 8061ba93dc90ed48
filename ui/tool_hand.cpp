// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_hand.h"

#include <algorithm>
#include <utility>

namespace hepatica {
namespace {

constexpr double least_notch_mm = 0.5;

// As an instrument comes: from the lower right, into the picture.
Vec3 way_of_instrument(const ViewAxes& axes) {
    return (0.5 * axes.forward - 0.62 * axes.right + 0.6 * axes.up).normalized();
}

}  // namespace

ToolHand::ToolHand(SceneView& view, std::function<void(Command)> post)
    : view_(view), post_(std::move(post)) {}

void ToolHand::take(const std::string& kind) {
    if (kind_.empty()) post_(UseTools{true});
    kind_ = kind;
    seen_.reset();
    asked_ = false;
    if (mouse_at_) bring_to(*mouse_at_);
}

void ToolHand::put_away() {
    if (kind_.empty()) return;
    kind_.clear();
    seen_.reset();
    asked_ = false;
    mouse_at_.reset();
    post_(RemoveTool{});
    post_(UseTools{false});
}

void ToolHand::set_size(const ToolSize& size) {
    size_ = size;
    if (!seen_) return;
    const ToolView::Part& part = seen_->parts.front();
    const Vec3 along = part.to_mm - part.from_mm;
    const Vec3 tip = seen_->tip_mm;
    const ViewAxes axes = view_.axes();
    bring(tip, kind_ == "sphere"   ? axes.forward
               : along.isZero(0.0) ? way_of_instrument(axes)
                                   : Vec3(along.normalized()));
}

void ToolHand::follow(const std::optional<ToolView>& tool) {
    if (kind_.empty()) return;
    if (tool && !seen_) depth_mm_ = tool->tip_mm;
    if (tool || seen_) asked_ = false;
    seen_ = tool;
}

void ToolHand::begin_again() {
    seen_.reset();
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
    const Vec3 tip = view_.point_at_depth(at, depth_mm_);
    post_(MoveTool{seen_->centre_mm + tip - seen_->tip_mm});
}

void ToolHand::press(const Pixel& at) {
    if (!kind_.empty() && !seen_) bring_to(at);
}

void ToolHand::shift_depth(double steps) {
    if (!seen_) return;
    depth_mm_ += steps * std::max(least_notch_mm, 0.5 * size_.radius_mm) * view_.axes().forward;
    if (mouse_at_) move(*mouse_at_);
}

void ToolHand::turn(double angle_rad) {
    if (seen_ && kind_ != "sphere") post_(TurnTool{-angle_rad * view_.axes().forward});
}

// To the vessel under the mouse, or as deep as what the picture is about.
void ToolHand::bring_to(const Pixel& at) {
    const ViewAxes axes = view_.axes();
    const SurfacePick pick = view_.pick(at);
    bring(pick.triangle >= 0 ? pick.position_mm : view_.point_at_depth(at, axes.focus_mm),
          kind_ == "sphere" ? view_.ray_through(at).direction : way_of_instrument(axes));
}

void ToolHand::bring(const Vec3& tip_mm, const Vec3& direction) {
    const double length_mm = kind_ == "sphere" ? 0.0 : size_.length_mm;
    post_(AddTool{kind_, size_.radius_mm, length_mm, direction, tip_mm});
    seen_.reset();
    asked_ = true;
}

}  // namespace hepatica
