// SPDX-License-Identifier: GPL-3.0-or-later
// Leads a tool by the mouse, without any toolkit. The tool appears at the mouse, as deep as it gets
// without touching anything; then its working point (ToolView::working_mm) follows the mouse in a
// plane parallel to the picture, which the wheel moves in depth. A new depth and a place far away
// are reached smoothly, by the play's time and without a timer. A click on a vessel, or on a mark
// of the lesson, brings it there. Obstacles stop it until there is room. The scene prepares for
// tools when the first is taken and releases that when the last is put away.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/scene/grip_watch.h"
#include "core/session/command.h"
#include "core/session/hand_pace.h"
#include "render/scene_view.h"

namespace hepatica {

// The user's choice; ranges as in ToolChoice.
struct ToolSize {
    double radius_mm = 2.0;
    double length_mm = 30.0;  // ignored by a sphere
};

// Over what time of the play, at least, the hand reaches the place that the wheel asks for: at once
// it would press or pull like a blow.
inline constexpr double wheel_over_s = 0.12;
// How fast a tool is led at most where the mouse is further from it than a hand's usual motion
// leaves it behind. Nearer than that, a HandPace alone says how fast.
inline constexpr double fastest_lead_mm_per_s = 150.0;
inline constexpr double usual_lag_mm = fastest_lead_mm_per_s * HandPace::longest_s;
// The time of a move where left_s of that is left and the mouse alone would take over_s (none: at
// once).
std::optional<double> at_least(double left_s, std::optional<double> over_s);

// UI thread only; the view must outlive it.
class ToolHand {
  public:
    using VesselDirection = std::function<Vec3(const SurfacePick& pick)>;
    ToolHand(SceneView& view, std::function<void(Command)> post, VesselDirection vessel_direction);

    // Takes a tool of this kind; it replaces another at the place of its tip.
    void take(const std::string& kind);
    void put_away();
    // Empties the hand without sending commands, before another simulation begins.
    void forget();
    bool holds() const { return !kind_.empty(); }
    const std::string& kind() const { return kind_; }

    // Adds the present tool again in this size, at the place of its tip.
    void set_size(const ToolSize& size);

    // Takes the tool of the newest frame.
    void follow(const std::optional<ToolView>& tool);
    // A simulation has begun that has no tool yet.
    void begin_again();

    void move(const Pixel& at);
    // Requests a tool that was refused once more.
    void press(const Pixel& at);
    // A click on a vessel or a mark that lies in front of the tool or behind it brings the tool
    // there anew, turned as it is; returns whether it does. A tool that touches something stays,
    // because it would let go of it, and so do closed jaws.
    bool click(const Pixel& at);
    // By notches of the wheel, > 0 away from the user.
    void shift_depth(double steps);
    // In the plane of the picture, counterclockwise.
    void turn(double angle_rad);
    // Forceps only: closes jaws that are commanded to be open, and opens others.
    void close_or_open();
    // Asked before what one points at brings the tool to its depth, by a click or where it is
    // taken; false: it is to be led there, and what asks has said why.
    std::function<bool()> may_bring = [] { return true; };
    // Called when closed jaws hold nothing.
    std::function<void(GripWatch::Seen)> on_empty_grip = [](GripWatch::Seen) {};

  private:
    // A tool that a new one takes the place of.
    struct Replaced {
        ToolView tool;
        AddTool added;                 // by which it came
        Vec3 place_mm = Vec3::Zero();  // where the new one is to come
        bool reshaped = false;         // the new one is of another kind or size
        bool rested = false;           // it was not led: whatever is elsewhere is the new one
        int frames = 60;               // after which whatever is shown counts as new
    };
    bool is_still_the_old(const ToolView& tool);
    void bring(const Vec3& place_mm, const Vec3& direction);
    void bring_to(const Pixel& at);
    // A new tool stops on its way before it touches something, and then lies beside the mouse.
    // Brings it again, to the mouse at the depth where it stopped; false where it need not.
    // Requires seen_.
    bool bring_again();
    // What one points at there: a vessel's surface, or a place at the depth of a mark.
    std::optional<Vec3> place_at(const Pixel& at) const;
    void lead_to(const Pixel& at, std::optional<double> over_s);
    // From the working point as it was seen last to the plane in which the mouse leads it. Requires
    // seen_.
    double depth_left_mm() const;
    Vec3 way_at(const Pixel& at) const;
    // In which the present tool points. Requires seen_.
    Vec3 present_way() const;

    SceneView& view_;
    std::function<void(Command)> post_;
    VesselDirection vessel_direction_;
    std::string kind_;  // empty: no tool
    ToolSize size_;
    std::optional<ToolView> seen_;
    std::optional<Replaced> replaced_;  // until a frame shows the new tool
    bool closed_ = false;               // jaws are commanded to be closed
    GripWatch grip_;
    bool asked_ = false;  // a tool was requested and no frame has shown it yet
    AddTool added_;       // the last that was sent
    int more_tries_ = 0;  // how often bring_again() may still do so
    HandPace pace_;
    Vec3 depth_mm_ = Vec3::Zero();  // a point of the plane in which it is led
    double depth_asked_mm_ = 0.0;   // what was left when the wheel was turned last
    std::optional<Pixel> mouse_at_;
};

}  // namespace hepatica
