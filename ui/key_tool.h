// SPDX-License-Identifier: GPL-3.0-or-later
// The three-dimensional view by keys alone, without any toolkit: they turn, pan and zoom the
// camera, and act where an aim in the middle of the picture points, as the mouse acts where it
// points.
//
//   arrows           turn by 5°           Shift + arrows   pan
//   + and -          zoom                 Home             the whole patient
//   Enter            what a click does in this mode; Ctrl + Enter what Ctrl + click does
// In pull mode Enter takes hold of the vessel in the middle, with a tool it brings the tool there,
// with blade or cut line it sets the pen down: arrows then lead it, Page Up and Page Down move a
// tool in depth, and Enter or Escape lets go.
#pragma once

#include <functional>

#include "ui/mouse_tool.h"

namespace hepatica {

enum class ViewKey { left, right, up, down, nearer, farther, whole, enter, escape, in, out };

// UI thread; view and mouse must outlive it.
class KeyTool {
  public:
    // `size`: of the picture, in pixels; `missed`: there is nothing to take hold of.
    KeyTool(SceneView& view, MouseTool& mouse, std::function<Pixel()> size,
            std::function<void()> missed);

    // False where the key means nothing here now, so that it is somebody else's.
    bool press(ViewKey key, const MouseModifiers& modifiers);
    // Something is led by the arrows.
    bool leads() const { return leads_; }
    // Where it was led to; the middle of the picture while nothing is.
    Pixel aim() const;
    // How far an arrow leads [pixels]. Follows the pixel ratio.
    void set_step(double pixels) { step_px_ = pixels; }
    // Lets go, as where the mouse takes over or the view loses the keys; a line that is being drawn
    // is given up.
    void let_go();

  private:
    void arrow(double right, double down, bool shift);
    void enter(const MouseModifiers& modifiers);

    SceneView& view_;
    MouseTool& mouse_;
    std::function<Pixel()> size_;
    std::function<void()> missed_;
    bool leads_ = false;
    Pixel led_to_;
    double step_px_ = 6.0;
};

}  // namespace hepatica
