// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse does in the three-dimensional view, without any toolkit: it turns presses, moves
// and releases into commands to the simulation and into movements of the camera.
//
//   left drag on a vessel    pull it                left drag beside the vessels   orbit
//   wheel                    zoom                   double-click, Ctrl + click     inject here
//   Alt + wheel              move the plane that opens the view
//   right and middle drag, Shift + left drag   the camera, as the scheme says (mouse_scheme.h)
// With a tool in hand the mouse leads it (tool_hand.h): every drag orbits or pans, the wheel moves
// the tool in depth (with Shift five times as far), Ctrl + wheel zooms.
// In cut and weaken mode a left drag draws a line across a vessel: a blade goes along it, or the
// vessel tears more easily there.
// In pull mode a click on a vessel points at it.
// In inject, edit, place and measure mode a plain click on a vessel injects, edits, sets a place or
// a point of what is measured there, and a drag that began on it orbits. In every mode a click on
// the dashed line of a gap bridges it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/session/command.h"
#include "core/session/hand_pace.h"
#include "render/scene_view.h"
#include "ui/clip_control.h"
#include "ui/mouse_scheme.h"
#include "ui/tool_hand.h"

namespace hepatica {

enum class MouseMode { pull, inject, edit, tool, cut, weaken, place, measure };

// UI thread; view must outlive it.
class MouseTool {
  public:
    struct Callbacks {
        std::function<void(Command)> post;                    // to the simulation
        std::function<void(const SurfacePick& pick)> inject;  // the user chose this point
        std::function<void(const SurfacePick& pick)> hover;   // triangle -1: beside the vessels
        // The user chose it in edit, place or measure mode.
        std::function<void(const SurfacePick& pick)> edit;
        std::function<void(int bridge)> accept_bridge;  // of those that the view shows
        // Which way the vessel runs there; 0 where that is not known.
        std::function<Vec3(const SurfacePick& pick)> vessel_direction;
        // A line was drawn in cut or weaken mode. Where it meets no vessel both points are none.
        std::function<void(MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke)> drawn;
        // A click for a vessel met none: in inject, edit, place or measure mode, or in pull mode
        // close beside one.
        std::function<void()> missed = [] {};
        // A plain click met this vessel in a mode in which it does nothing else.
        std::function<void(const SurfacePick& pick)> pointed = [](const SurfacePick&) {};
    };
    MouseTool(SceneView& view, Callbacks callbacks);

    // Puts a tool away that is in hand, unless the mode is that of tools.
    void set_mode(MouseMode mode);
    MouseMode mode() const { return mode_; }
    void set_scheme(const MouseScheme& scheme) { scheme_ = &scheme; }
    // Where it may not, a drag on a vessel turns the view.
    void set_may_pull(bool may_pull) { may_pull_ = may_pull; }
    bool may_pull() const { return may_pull_; }
    ToolHand& hand() { return hand_; }
    ClipControl& clip() { return clip_; }

    // How far, in pixels, a press may move and still be a click. Follows the pixel ratio.
    void set_click_radius(double pixels) { click_radius_px_ = pixels; }

    void press(const Pixel& at, MouseButton button, const MouseModifiers& modifiers);
    // True where the camera has moved, so that the picture is to be drawn anew; what a pull moves
    // comes with a later frame.
    bool move(const Pixel& at);
    void release(const Pixel& at);
    // The second press of a double click, in place of press(). Injects, unless the first click has
    // done what a click does here: bridged a gap, or injected already.
    void double_click(const Pixel& at);
    // Wheel turned by `steps` notches away from the user (nearer) or towards (farther).
    void wheel(double steps, const MouseModifiers& modifiers = {});
    // Lets go of whatever is held, as when the window loses the mouse.
    void cancel();

    bool pulling() const { return action_ == Action::pull; }
    // A vessel, or the pen of a line.
    bool holds() const { return pulling() || action_ == Action::draw; }
    bool waits_for_click() const { return action_ == Action::wait_for_click; }

  private:
    enum class Action { none, pull, orbit, pan, zoom, wait_for_click, draw };

    void click_at(const Pixel& at);
    // A vessel is so near that a hand may have meant it.
    bool is_near_miss(const Pixel& at) const;
    bool is_click(const Pixel& at) const;  // and no drag
    // Whether a plain click is for a vessel.
    bool clicks_vessels() const { return mode_ == MouseMode::inject || chooses(); }
    // Whether it is told to callbacks_.edit.
    bool chooses() const {
        return mode_ == MouseMode::edit || mode_ == MouseMode::place || mode_ == MouseMode::measure;
    }
    bool draws() const { return mode_ == MouseMode::cut || mode_ == MouseMode::weaken; }
    // Between where the line that is drawn first and last meets the vessels, at their depth.
    std::optional<std::array<Vec3, 2>> stroke_to(const Pixel& at) const;
    void inject_at(const Pixel& at);

    SceneView& view_;
    Callbacks callbacks_;
    ToolHand hand_;
    ClipControl clip_{view_};
    const MouseScheme* scheme_ = &mouse_schemes().front();
    MouseMode mode_ = MouseMode::pull;
    bool may_pull_ = true;
    Action action_ = Action::none;
    bool clicked_ = false;       // the last press ended as a click
    bool dragged_ = false;       // since the last press
    bool pressed_left_ = false;  // and for no gesture of the camera
    SurfacePick pulled_;         // what is or was pulled last
    Pixel pressed_;
    Pixel last_;
    HandPace pace_;                // of a pull
    Vec3 held_mm_ = Vec3::Zero();  // where the vessel was when it was taken
    int pressed_bridge_ = -1;      // waits for the click
    double click_radius_px_ = 4.0;
};

}  // namespace hepatica
