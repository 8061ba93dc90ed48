// SPDX-License-Identifier: GPL-3.0-or-later
// A tool in the hand of the mouse, without any toolkit. It comes into the picture where the mouse
// is; then its tip follows the mouse in a plane parallel to the picture, which the wheel moves in
// depth. What it meets stops it, and it goes on when there is room. A scene builds what tools need
// when the first is taken in hand, and lets go of it when the last is put away.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/session/command.h"
#include "core/session/hand_pace.h"
#include "render/scene_view.h"
#include "ui/grip_watch.h"

namespace hepatica {

// What a person chooses of a tool; ranges as in ToolChoice.
struct ToolSize {
    double radius_mm = 2.0;
    double length_mm = 30.0;  // means nothing to a sphere
};

// UI thread; view must outlive it.
class ToolHand {
  public:
    using VesselDirection = std::function<Vec3(const SurfacePick& pick)>;
    ToolHand(SceneView& view, std::function<void(Command)> post, VesselDirection vessel_direction);

    // The tool of this kind in place of another, and where that one's tip was.
    void take(const std::string& kind);
    void put_away();
    // Empties the hand without a word to a simulation, as before another one begins.
    void forget();
    bool holds() const { return !kind_.empty(); }
    const std::string& kind() const { return kind_; }

    // A tool that is there comes again, with the other size, to where its tip was.
    void set_size(const ToolSize& size);

    // What the newest frame shows.
    void follow(const std::optional<ToolView>& tool);
    // A simulation has begun that knows of no tool.
    void begin_again();

    void move(const Pixel& at);
    // Brings a tool that was refused once more.
    void press(const Pixel& at);
    // By notches of the wheel, away from the user.
    void shift_depth(double steps);
    // In the plane of the picture, against the clock.
    void turn(double angle_rad);
    // Forceps alone: closes jaws that are led to be open, and opens others.
    void close_or_open();
    // Jaws that were closed hold nothing.
    std::function<void(GripWatch::Seen)> on_empty_grip = [](GripWatch::Seen) {};

  private:
    void bring(const Vec3& tip_mm, const Vec3& direction);
    void bring_to(const Pixel& at);
    Vec3 way_at(const Pixel& at) const;

    SceneView& view_;
    std::function<void(Command)> post_;
    VesselDirection vessel_direction_;
    std::string kind_;  // empty: the hand is empty
    ToolSize size_;
    std::optional<ToolView> seen_;
    bool closed_ = false;  // jaws are led to be
    GripWatch grip_;
    bool asked_ = false;  // it was sent for, and no frame has shown it yet
    HandPace pace_;
    Vec3 depth_mm_ = Vec3::Zero();  // a point of the plane in which the tip is led
    std::optional<Pixel> mouse_at_;
};

}  // namespace hepatica
