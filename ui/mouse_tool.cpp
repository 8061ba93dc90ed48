// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mouse_tool.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/pointed_place.h"

namespace hepatica {

MouseTool::MouseTool(SceneView& view, Callbacks callbacks)
    : view_(view),
      callbacks_(std::move(callbacks)),
      hand_(view, callbacks_.post, callbacks_.vessel_direction) {}

void MouseTool::set_mode(MouseMode mode) {
    cancel();
    mode_ = mode;
    if (mode != MouseMode::tool) hand_.put_away();
}

void MouseTool::press(const Pixel& at, MouseButton button, const MouseModifiers& modifiers) {
    cancel();
    clicked_ = dragged_ = false;
    callbacks_.hover(SurfacePick{});  // no highlight while a button is down
    pressed_ = last_ = at;
    pressed_left_ = false;
    if (const auto gesture = scheme_->camera(button, modifiers)) {
        action_ = *gesture == CameraGesture::pan    ? Action::pan
                  : *gesture == CameraGesture::zoom ? Action::zoom
                                                    : Action::orbit;
        return;
    }
    const bool left = pressed_left_ = button == MouseButton::left;
    if (left && draws() && !modifiers.control) {
        action_ = Action::draw;
        return;
    }
    pressed_bridge_ = left && takes_lines() ? view_.bridge_at(at, 1.5 * click_radius_px_) : -1;
    const bool leads = mode_ == MouseMode::tool && !modifiers.control;
    if (left && leads) hand_.press(at);
    const SurfacePick pick = left && !leads ? view_.pick(at) : SurfacePick{};
    const bool pulls = left && mode_ == MouseMode::pull && !modifiers.control && may_pull();
    const auto held_mm = pulls ? pointed_place(view_, at, pick, 1.0) : std::nullopt;
    if (pressed_bridge_ >= 0) {
        action_ = Action::wait_for_click;
    } else if (held_mm) {
        action_ = Action::pull;
        pulled_ = *held_mm == pick.position_mm ? pick : SurfacePick{};
        held_mm_ = *held_mm;
        pace_ = HandPace(HandPace::Clock::now());
        zoomed_.reset();
        callbacks_.post(GrabPoint{held_mm_});
    } else if (pick.triangle < 0) {
        action_ = left && clicks_vessels() ? Action::wait_for_click : Action::orbit;
    } else if (mode_ != MouseMode::pull || modifiers.control) {
        action_ = Action::wait_for_click;
    } else {
        action_ = Action::orbit;
    }
}

bool MouseTool::move(const Pixel& at) {
    const Pixel from = std::exchange(last_, at);
    dragged_ |= !is_click(at);
    switch (action_) {
        case Action::none:
            if (mode_ == MouseMode::tool) {
                hand_.move(at);
                return false;
            }
            if (draws()) return false;
            callbacks_.hover(view_.pick(at));
            return false;
        case Action::pull:
            pull_to(at);
            return false;
        case Action::draw:
            view_.set_stroke(std::array{view_.point_at_depth(pressed_, view_.axes().focus_mm),
                                        view_.point_at_depth(at, view_.axes().focus_mm)});
            return true;
        case Action::pan:
            view_.drag_pan(from, at);
            return true;
        case Action::zoom:  // upwards: nearer
            view_.zoom_by(std::pow(1.01, from.y - at.y));
            return true;
        case Action::wait_for_click:
            if (is_click(at)) {
                last_ = from;
                return false;
            }
            action_ = Action::orbit;
            [[fallthrough]];
        case Action::orbit:
            view_.drag_orbit(from, at);
            return true;
    }
    return false;
}

void MouseTool::pull_to(const Pixel& at) {
    const HandPace::Clock::time_point now = HandPace::Clock::now();
    const double left_s =
        zoomed_ ? wheel_over_s - std::chrono::duration<double>(now - *zoomed_).count() : 0.0;
    callbacks_.post(
        MoveGrab{view_.point_at_depth(at, held_mm_), at_least(left_s, pace_.heard(now))});
}

bool MouseTool::is_click(const Pixel& at) const {
    return std::hypot(at.x - pressed_.x, at.y - pressed_.y) <= click_radius_px_;
}

void MouseTool::release(const Pixel& at) {
    clicked_ = action_ == Action::wait_for_click;
    const bool points = pulling() && !dragged_ && pulled_.triangle >= 0;
    const bool tried_to_pull =
        action_ == Action::orbit && mode_ == MouseMode::pull && !dragged_ && pressed_left_;
    const bool brings_tool =
        action_ == Action::orbit && mode_ == MouseMode::tool && !dragged_ && pressed_left_;
    if (action_ == Action::draw) callbacks_.drawn(mode_, stroke_to(at));
    cancel();
    if (brings_tool) hand_.click(at);
    if (clicked_) click_at(at);
    if (points) callbacks_.pointed(pulled_);
    if (tried_to_pull && (may_pull() ? is_near_miss(at) : view_.pick(at).triangle >= 0))
        callbacks_.missed();
}

bool MouseTool::takes_double_click(const Pixel& at, MouseButton button,
                                   const MouseModifiers& modifiers) const {
    if (button != MouseButton::left || scheme_->camera(button, modifiers) || draws()) return false;
    return mode_ != MouseMode::pull || clicked_ || view_.pick(at).triangle >= 0;
}

void MouseTool::double_click(const Pixel& at) {
    cancel();
    const bool injects = mode_ == MouseMode::pull || mode_ == MouseMode::inject;
    if (injects && !clicked_) inject_at(at);
}

void MouseTool::wheel(double steps, const MouseModifiers& modifiers) {
    if (modifiers.alt) return clip_.shift(clip_step_mm * steps);
    constexpr double with_shift = 5.0;
    if (mode_ == MouseMode::tool && !modifiers.control)
        return hand_.shift_depth(modifiers.shift ? with_shift * steps : steps);
    view_.zoom_by(std::pow(1.15, steps));
    if (!pulling()) return;
    // The place under the mouse is another one now.
    callbacks_.post(MoveGrab{view_.point_at_depth(last_, held_mm_), wheel_over_s});
    zoomed_ = HandPace::Clock::now();
}

void MouseTool::cancel() {
    if (action_ == Action::pull) callbacks_.post(ReleaseGrab{});
    if (action_ == Action::draw) view_.set_stroke(std::nullopt);
    action_ = Action::none;
}

std::optional<std::array<Vec3, 2>> MouseTool::stroke_to(const Pixel& at) const {
    constexpr int samples = 48;
    std::optional<Vec3> depth;
    for (int i = 0; i <= samples && !depth; ++i) {
        // From the middle outwards, because a vessel is usually crossed there.
        const double share = 0.5 + (i % 2 == 0 ? 0.5 : -0.5) * i / samples;
        const SurfacePick pick = view_.pick(
            {pressed_.x + share * (at.x - pressed_.x), pressed_.y + share * (at.y - pressed_.y)});
        if (pick.triangle >= 0) depth = pick.position_mm;
    }
    if (!depth) return std::nullopt;
    return std::array{view_.point_at_depth(pressed_, *depth), view_.point_at_depth(at, *depth)};
}

void MouseTool::click_at(const Pixel& at) {
    const SurfacePick pick = view_.pick(at);
    // What edits vessels goes to the vessel, also where a line is drawn over it.
    const bool for_vessel = mode_ == MouseMode::edit && pick.triangle >= 0;
    if (pressed_bridge_ >= 0 && !for_vessel) return callbacks_.click_line(pressed_bridge_);
    if (pick.triangle < 0) return callbacks_.missed();
    if (chooses())
        callbacks_.edit(pick);
    else
        callbacks_.inject(pick);
}

bool MouseTool::is_near_miss(const Pixel& at) const {
    constexpr int directions = 8;
    for (const double click_radii : {2.0, 4.0, 6.0})
        for (int i = 0; i < directions; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / directions;
            const double away = click_radii * click_radius_px_;
            if (view_.pick({at.x + away * std::cos(angle), at.y + away * std::sin(angle)})
                    .triangle >= 0)
                return true;
        }
    return false;
}

void MouseTool::inject_at(const Pixel& at) {
    const SurfacePick pick = view_.pick(at);
    if (pick.triangle >= 0) callbacks_.inject(pick);
}

}  // namespace hepatica
