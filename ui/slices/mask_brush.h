// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of a brush over the vessels' voxels, which a person paints or erases in the slices before
// the vessels are made anew of them. Each is somebody else's to keep as soon as the brush is
// lifted. No widget.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/image/brush.h"
#include "core/reconstruction/remade_case.h"

namespace hepatica {

// What painted voxels hold until they are made into vessels: no system's number, so that they have
// a colour of their own.
inline constexpr std::uint8_t painted_label = painted_voxel;

enum class BrushMode { away, paints, erases };

// Whether a stroke that is led on to this place gets any longer by it: the ball sweeps what lies
// between, and nearer points would add nothing.
bool is_worth_a_step(const BrushStroke& stroke, const Vec3& place_mm);

// UI thread.
class MaskBrush {
  public:
    struct Hand {
        // A stroke has been led.
        std::function<void(const BrushStroke&)> add = [](const BrushStroke&) {};
        // So many of the last strokes were taken back; whoever does not want that shows them again.
        std::function<void(std::size_t)> take_back = [](std::size_t) {};
    };
    static constexpr double least_mm = 0.5, most_mm = 20.0;

    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }
    void on_stroke(Hand hand) { hand_ = std::move(hand); }
    // The vessels shall be made anew of the voxels as they are now.
    void on_remake(std::function<void()> remake) { remake_ = std::move(remake); }

    void set_mode(BrushMode mode);  // strokes stay
    BrushMode mode() const { return mode_; }
    void set_radius(double radius_mm);  // to the nearest one that it can have
    double radius_mm() const { return radius_mm_; }

    // A stroke where the brush is put down, and on to where it is led until it is lifted; nothing
    // while it is away.
    void begin(const Vec3& place_mm);
    void lead_to(const Vec3& place_mm);
    void lift();
    bool leads() const { return down_; }
    // The stroke that is being led, or else the last one; all of them.
    void remove_last();
    void remove_all();
    // These and no others, as somebody else has kept them: the hand is not told. One that is being
    // led ends without a trace, unless these are those from before it.
    void show(const std::vector<BrushStroke>& strokes);
    // Asks for it where there are strokes.
    void remake() const;

    const std::vector<BrushStroke>& strokes() const { return strokes_; }

  private:
    void tell() const;

    Hand hand_;
    std::function<void()> remake_;
    BrushMode mode_ = BrushMode::away;
    double radius_mm_ = 2.0;
    bool down_ = false;
    std::vector<BrushStroke> strokes_;
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
