// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/key_tool.h"

#include <algorithm>
#include <utility>

namespace hepatica {
namespace {

constexpr double turn_deg = 5.0;  // per key press
constexpr double zoom_of_a_key = 1.15;
constexpr double pan_share = 0.04;  // of the picture's height, per key press

}  // namespace

KeyTool::KeyTool(SceneView& view, MouseTool& mouse, std::function<Pixel()> size,
                 std::function<void()> missed)
    : view_(view), mouse_(mouse), size_(std::move(size)), missed_(std::move(missed)) {}

Pixel KeyTool::aim() const {
    if (leads_) return led_to_;
    const Pixel size = size_();
    return {0.5 * size.x, 0.5 * size.y};
}

bool KeyTool::press(ViewKey key, const MouseModifiers& modifiers) {
    switch (key) {
        case ViewKey::left:
            arrow(-1, 0, modifiers.shift);
            return true;
        case ViewKey::right:
            arrow(1, 0, modifiers.shift);
            return true;
        case ViewKey::up:
            arrow(0, -1, modifiers.shift);
            return true;
        case ViewKey::down:
            arrow(0, 1, modifiers.shift);
            return true;
        case ViewKey::nearer:
            view_.zoom_by(zoom_of_a_key);
            return true;
        case ViewKey::farther:
            view_.zoom_by(1.0 / zoom_of_a_key);
            return true;
        case ViewKey::whole:
            view_.show_whole();
            return true;
        case ViewKey::enter:
            enter(modifiers);
            return true;
        case ViewKey::escape:
            if (!leads_) return false;
            let_go();
            return true;
        case ViewKey::in:
        case ViewKey::out:
            if (!leads_ || mouse_.mode() != MouseMode::tool) return false;
            mouse_.wheel(key == ViewKey::in ? 1.0 : -1.0, {.shift = modifiers.shift});
            return true;
    }
    return false;
}

void KeyTool::arrow(double right, double down, bool shift) {
    if (leads_) {
        const Pixel size = size_();
        brought_ = false;
        led_to_ = {std::clamp(led_to_.x + step_px_ * right, 0.0, size.x),
                   std::clamp(led_to_.y + step_px_ * down, 0.0, size.y)};
        mouse_.move(led_to_);
        return;
    }
    if (shift) {
        const double step = pan_share * size_().y;
        // The view moves in the direction of the arrow.
        return view_.drag_pan({0, 0}, {step * right, step * down});
    }
    view_.turn_by(turn_deg * right, turn_deg * down);
}

void KeyTool::enter(const MouseModifiers& modifiers) {
    const bool tool = mouse_.mode() == MouseMode::tool;
    if (leads_) {
        // Once at a place: what stands in a tool's way may keep it from where it was brought to.
        if (tool && !std::exchange(brought_, true) && mouse_.hand().click(led_to_)) return;
        mouse_.release(led_to_);
        leads_ = false;
        return;
    }
    const Pixel at = aim();
    if (tool && !modifiers.control) {
        mouse_.move(at);
        mouse_.hand().click(at);
        leads_ = brought_ = true;
        led_to_ = at;
        return;
    }
    mouse_.press(at, MouseButton::left, modifiers);
    leads_ = mouse_.holds();
    led_to_ = at;
    if (leads_) return;
    mouse_.waits_for_click() ? mouse_.release(at) : missed_();
    mouse_.cancel();
}

void KeyTool::let_go() {
    if (std::exchange(leads_, false)) mouse_.cancel();
}

}  // namespace hepatica
