// SPDX-License-Identifier: GPL-3.0-or-later
// Brush that paints and erases tumours in the organ mask: which tumour, and the effect of the
// unfinished stroke. A stroke becomes a correction when the brush is lifted. No widgets.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/patient/painted_tumours.h"
#include "ui/slices/mask_brush.h"
#include "ui/slices/watchers.h"

namespace hepatica {

// UI thread only.
class TumourBrush {
  public:
    struct Hand {
        // A stroke was finished. The receiver calls show() with or without it.
        std::function<void(const TreeEdit&)> add;
        // The last n strokes are to be taken back.
        std::function<void(std::size_t)> take_back;
        // The voxels are to be shown without the unfinished stroke.
        std::function<void()> show_again;
    };

    // Called after every change.
    void on_change(std::function<void()> tell) { watchers_.add(std::move(tell)); }
    void on_stroke(Hand hand) { hand_ = std::move(hand); }

    // Shows the organs as `strokes` strokes have left them on the canvas (tumour_canvas()). An
    // unfinished stroke is dropped.
    void show(std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes);
    // No voxels are known, for this reason; an empty reason means that they are still being read.
    void show_none(std::string why_none);
    // Empty if no voxels are known.
    const Mask& organs() const { return organs_; }
    const std::vector<Tumour>& tumours() const { return tumours_; }
    int tumour_at(const Vec3& position_mm) const;  // 0 if none

    void set_mode(BrushMode mode);
    BrushMode mode() const { return mode_; }
    // Number of an existing tumour; 0: a new one is painted, any is erased.
    void choose(int tumour);
    int chosen() const { return chosen_; }

    // Why a brush cannot paint at this place; empty if it can.
    std::string why_not_painted(const Vec3& position_mm) const;
    // begin() starts a stroke and lead_to() extends it; begin() has no effect in mode `away` or
    // where why_not_painted() gives a reason.
    void begin(const Vec3& place_mm, double radius_mm);
    void lead_to(const Vec3& place_mm);
    // Ends the stroke and hands it over. Returns why it changed nothing; empty if it did.
    std::string lift();
    // Strokes since the brush was taken up.
    std::size_t strokes_made() const { return strokes_ - strokes_before_; }
    // Removes the unfinished stroke, else the last one.
    void remove_last();
    // Removes the unfinished stroke, else all strokes; if none can be taken back, puts the brush
    // away.
    void give_up();

  private:
    bool drop_led();
    void take_back(std::size_t strokes);
    void leave(const std::vector<Vec3>& path_mm);

    Hand hand_;
    std::shared_ptr<const Mask> canvas_;
    Mask organs_;
    std::vector<Tumour> tumours_;
    std::string why_none_;
    std::size_t strokes_ = 0, strokes_before_ = 0;
    BrushMode mode_ = BrushMode::away;
    int chosen_ = 0;
    // Chosen tumour that was taken back and is chosen again when it returns; 0: none.
    int gone_ = 0;
    std::optional<TreeEdit> led_;  // unfinished stroke
    std::size_t changes_ = 0;      // voxels changed by led_
    Watchers watchers_;
};

}  // namespace hepatica
