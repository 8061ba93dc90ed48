// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse control of the 3D view, without any toolkit: turns presses, moves and releases into
// commands to the simulation and movements of the camera.
//
//   left drag on a vessel    pull it                left drag beside the vessels   orbit
//   wheel                    zoom                   double-click, Ctrl + click     inject here
//   Alt + wheel              move the plane that opens the view
//   right and middle drag, Shift + left drag   the camera, as the scheme says (mouse_scheme.h)
// With a tool in hand the mouse leads it (tool_hand.h): every drag orbits or pans, the wheel moves
// the tool in depth (with Shift five times as far), Ctrl + wheel zooms, and a click on a vessel or
// a mark of the lesson brings the tool there.
// In cut and weaken mode a left drag draws a line across a vessel, which is cut or weakened there.
// In pull mode a drag on a mark of the lesson pulls the vessel of the mark, even where another one,
// a centimetre or more in front, hides it, and a click on a vessel calls `pointed`. In inject,
// edit, place and measure mode a click on a vessel injects, edits, or sets a place or a point of a
// measurement, and a drag orbits. In pull, inject and the tools' modes a click on the dashed line
// of a gap bridges it; in edit mode it chooses the line.
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

// UI thread only; the view must outlive it.
class MouseTool {
  public:
    struct Callbacks {
        std::function<void(Command)> post;                    // to the simulation
        std::function<void(const SurfacePick& pick)> inject;  // the user chose this point
        std::function<void(const SurfacePick& pick)> hover;   // triangle -1: no vessel
        // The user clicked on this point in edit, place or measure mode.
        std::function<void(const SurfacePick& pick)> edit;
        // A click on the line of a gap or doubtful branch; in edit mode only where no vessel is.
        std::function<void(int line)> click_line;  // index among the bridges shown by the view
        // Direction of the vessel there; zero if unknown.
        std::function<Vec3(const SurfacePick& pick)> vessel_direction;
        // A line was drawn in cut or weaken mode; nullopt if it meets no vessel.
        std::function<void(MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke)> drawn;
        // A click missed the vessels: in inject, edit, place or measure mode, or in pull mode close
        // to one; or it hit one in pull mode that may not be pulled.
        std::function<void()> missed = [] {};
        // A click hit this vessel in pull mode.
        std::function<void(const SurfacePick& pick)> pointed = [](const SurfacePick&) {};
    };
    MouseTool(SceneView& view, Callbacks callbacks);

    // Puts the tool away unless the mode is `tool`.
    void set_mode(MouseMode mode);
    MouseMode mode() const { return mode_; }
    void set_scheme(const MouseScheme& scheme) { scheme_ = &scheme; }
    const MouseScheme& scheme() const { return *scheme_; }
    // If false, a drag on a vessel turns the view.
    void set_may_pull(bool may_pull) { may_pull_ = may_pull; }
    // Whether there is a body to pull; likewise.
    void set_moves(bool moves) { moves_ = moves; }
    bool moves() const { return moves_; }
    bool may_pull() const { return may_pull_ && moves_; }
    ToolHand& hand() { return hand_; }
    ClipControl& clip() { return clip_; }

    // Distance in pixels by which a press may move and still be a click; depends on the pixel
    // ratio.
    void set_click_radius(double pixels) { click_radius_px_ = pixels; }

    // Mouse events, in pixels of the picture.
    void press(const Pixel& at, MouseButton button, const MouseModifiers& modifiers);
    // Returns whether the camera or the drawn line has changed, so that a new picture is needed.
    // The effect of a pull comes with a later frame.
    bool move(const Pixel& at);
    void release(const Pixel& at);
    // Whether the second press of a double click is for double_click(), not press() as any other:
    // not where it moves the camera or begins a line.
    bool takes_double_click(const Pixel& at, MouseButton button,
                            const MouseModifiers& modifiers) const;
    // The second press of a double click, instead of press(). Injects, unless the first click did
    // something already: bridged a gap or injected.
    void double_click(const Pixel& at);
    // `steps`: notches, > 0 away from the user (nearer).
    void wheel(double steps, const MouseModifiers& modifiers = {});
    // Lets go of whatever is held, for example when the window loses the mouse.
    void cancel();

    bool pulling() const { return action_ == Action::pull; }
    // A vessel, or the end of a line.
    bool holds() const { return pulling() || action_ == Action::draw; }
    bool waits_for_click() const { return action_ == Action::wait_for_click; }

  private:
    enum class Action { none, pull, orbit, pan, zoom, wait_for_click, draw };

    void click_at(const Pixel& at);
    // Whether a vessel is so near that the user may have meant it.
    bool is_near_miss(const Pixel& at) const;
    bool is_click(const Pixel& at) const;  // not a drag
    // Whether a plain click is for a vessel.
    bool clicks_vessels() const { return mode_ == MouseMode::inject || chooses(); }
    // Whether a click calls callbacks_.edit.
    bool chooses() const {
        return mode_ == MouseMode::edit || mode_ == MouseMode::place || mode_ == MouseMode::measure;
    }
    // Whether a click may be for a dashed line: not where it names a place on a vessel.
    bool takes_lines() const { return mode_ != MouseMode::place && mode_ != MouseMode::measure; }
    bool draws() const { return mode_ == MouseMode::cut || mode_ == MouseMode::weaken; }
    // The drawn line from press to release, at the depth of the vessel that it meets nearest to its
    // middle; nullopt if it meets none.
    std::optional<std::array<Vec3, 2>> stroke_to(const Pixel& at) const;
    void inject_at(const Pixel& at);
    void pull_to(const Pixel& at);

    SceneView& view_;
    Callbacks callbacks_;
    ToolHand hand_;
    ClipControl clip_{view_};
    const MouseScheme* scheme_ = &mouse_schemes().front();
    MouseMode mode_ = MouseMode::pull;
    bool may_pull_ = true, moves_ = true;
    Action action_ = Action::none;
    bool clicked_ = false;       // the last press ended as a click
    bool dragged_ = false;       // since the last press
    bool pressed_left_ = false;  // and was no gesture of the camera
    SurfacePick pulled_;         // pulled now or last
    Pixel pressed_;
    Pixel last_;
    HandPace pace_;                                      // of a pull
    std::optional<HandPace::Clock::time_point> zoomed_;  // by the wheel, during this pull
    Vec3 held_mm_ = Vec3::Zero();                        // where the vessel was grabbed
    int pressed_bridge_ = -1;                            // waits for the click
    double click_radius_px_ = 4.0;
};

}  // namespace hepatica
