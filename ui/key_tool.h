// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard control of the 3D view, without any toolkit: turns, pans and zooms the camera, and acts
// at an aim in the middle of the picture as the mouse does at the pointer.
//
//   arrows           turn by 5°           Shift + arrows   pan
//   + and -          zoom                 Home             the whole patient
//   Enter            what a click does in this mode; Ctrl + Enter what Ctrl + click does
// In pull mode Enter grabs the vessel in the middle, with a tool it brings the tool there, with
// blade or cut line it begins a line. Arrows then move it, Page Up and Page Down move a tool in
// depth (with Shift five times as far), and Enter or Escape lets go. On a vessel or a mark at
// another depth Enter first brings the tool to that, as a click does.
#pragma once

#include <functional>

#include "ui/mouse_tool.h"

namespace hepatica {

enum class ViewKey { left, right, up, down, nearer, farther, whole, enter, escape, in, out };

// UI thread only; view and mouse must outlive it.
class KeyTool {
  public:
    // `size` returns the picture's size in pixels; `missed` is called if there is nothing to grab.
    KeyTool(SceneView& view, MouseTool& mouse, std::function<Pixel()> size,
            std::function<void()> missed);

    // Returns false if the key has no meaning here now.
    bool press(ViewKey key, const MouseModifiers& modifiers);
    // Whether the arrows move something.
    bool leads() const { return leads_; }
    // Where it was moved to; the middle of the picture if nothing is moved.
    Pixel aim() const;
    // Pixels per arrow key; depends on the pixel ratio.
    void set_step(double pixels) { step_px_ = pixels; }
    // Lets go, when the mouse takes over or the view loses the focus; an unfinished line is
    // dropped.
    void let_go();

  private:
    void arrow(double right, double down, bool shift);
    void enter(const MouseModifiers& modifiers);

    SceneView& view_;
    MouseTool& mouse_;
    std::function<Pixel()> size_;
    std::function<void()> missed_;
    bool leads_ = false;
    bool brought_ = false;  // a tool, to led_to_, by Enter
    Pixel led_to_;
    double step_px_ = 6.0;
};

}  // namespace hepatica
