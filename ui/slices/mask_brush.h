// SPDX-License-Identifier: GPL-3.0-or-later
// Brush strokes that add voxels to the vessel mask or erase them, painted in the slices before the
// vessels are rebuilt from the mask. A stroke is handed over when the brush is lifted. No widgets.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/image/brush.h"
#include "core/reconstruction/remade_case.h"
#include "ui/slices/watchers.h"

namespace hepatica {

// Label of painted voxels until the vessels are rebuilt. It is no vascular system's number, so that
// painted voxels have a colour of their own.
inline constexpr std::uint8_t painted_label = painted_voxel;

enum class BrushMode { away, paints, erases };

// Whether the place is far enough from the stroke's end to extend it: a fifth of the radius. The
// ball sweeps the space between, so nearer points would add nothing.
bool is_worth_a_step(const BrushStroke& stroke, const Vec3& place_mm);

// UI thread only.
class MaskBrush {
  public:
    struct Hand {
        // A stroke has been finished.
        std::function<void(const BrushStroke&)> add = [](const BrushStroke&) {};
        // The last n strokes were taken back. A receiver that disagrees calls show() with them.
        std::function<void(std::size_t)> take_back = [](std::size_t) {};
    };
    static constexpr double least_mm = 0.5, most_mm = 20.0, step_mm = 0.5;

    // Called after every change of mode, radius or strokes.
    void on_change(std::function<void()> tell) { watchers_.add(std::move(tell)); }
    void on_stroke(Hand hand) { hand_ = std::move(hand); }
    // The user wants the vessels rebuilt from the mask as it is now.
    void on_remake(std::function<void()> remake) { remake_ = std::move(remake); }

    void set_mode(BrushMode mode);  // the strokes stay
    BrushMode mode() const { return mode_; }
    void set_radius(double radius_mm);  // clamped to [least_mm, most_mm]
    void resize(int steps) { set_radius(radius_mm_ + steps * step_mm); }  // by keys
    double radius_mm() const { return radius_mm_; }

    // begin() starts a stroke, lead_to() extends it and lift() ends it. No effect in mode `away`.
    void begin(const Vec3& place_mm);
    void lead_to(const Vec3& place_mm);
    void lift();
    bool leads() const { return down_; }
    // Removes the unfinished stroke, else the last one; or all strokes.
    void remove_last();
    void remove_all();
    // Replaces the strokes without telling the hand. An unfinished stroke is dropped, unless the
    // given strokes are exactly those before it.
    void show(const std::vector<BrushStroke>& strokes);
    // Asks for a rebuild if there are strokes.
    void remake() const;

    const std::vector<BrushStroke>& strokes() const { return strokes_; }

  private:
    Hand hand_;
    std::function<void()> remake_;
    BrushMode mode_ = BrushMode::away;
    double radius_mm_ = 2.0;
    bool down_ = false;
    std::vector<BrushStroke> strokes_;
    Watchers watchers_;
};

}  // namespace hepatica
