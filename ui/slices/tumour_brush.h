// SPDX-License-Identifier: GPL-3.0-or-later
// A brush at tumours over the organs' voxels in the slices: which tumour is painted or erased, and
// what the stroke that is being led leaves. A stroke is a correction as soon as the brush is
// lifted. No widget.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/patient/painted_tumours.h"
#include "ui/slices/mask_brush.h"

namespace hepatica {

// UI thread.
class TumourBrush {
  public:
    struct Hand {
        // A stroke has been led. Whoever takes it shows the voxels with it, or without.
        std::function<void(const TreeEdit&)> add;
        // So many of the last strokes shall be taken back.
        std::function<void(std::size_t)> take_back;
        // The voxels shall be shown without the stroke that was being led.
        std::function<void()> show_again;
    };

    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }
    void on_stroke(Hand hand) { hand_ = std::move(hand); }

    // The organs as so many strokes have left them on the canvas (tumour_canvas()). A stroke that
    // is being led ends.
    void show(std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes);
    // No voxels are known, for the reason given; without one: not yet.
    void show_none(std::string why_none);
    // Empty where no voxels are known.
    const Mask& organs() const { return organs_; }
    const std::vector<Tumour>& tumours() const { return tumours_; }
    int tumour_at(const Vec3& position_mm) const;  // 0: none

    void set_mode(BrushMode mode);
    BrushMode mode() const { return mode_; }
    // Number of a tumour that is there; 0: a new one is painted, any is erased.
    void choose(int tumour);
    int chosen() const { return chosen_; }

    // Why a brush leaves nothing at this place; empty: it does.
    std::string why_not_painted(const Vec3& position_mm) const;
    void begin(const Vec3& place_mm, double radius_mm);
    void lead_to(const Vec3& place_mm);
    // Hands the stroke over, and says why not where it changed nothing.
    std::string lift();
    // Strokes since the brush was taken up.
    std::size_t strokes_made() const { return strokes_ - strokes_before_; }
    // The stroke that is being led, or else the last one.
    void remove_last();
    // The stroke that is being led, or else all of them; where none can be taken back the brush is
    // put away.
    void give_up();

  private:
    bool drop_led();
    void take_back(std::size_t strokes);
    void leave(const std::vector<Vec3>& path_mm);
    void tell() const;

    Hand hand_;
    std::shared_ptr<const Mask> canvas_;
    Mask organs_;
    std::vector<Tumour> tumours_;
    std::string why_none_;
    std::size_t strokes_ = 0, strokes_before_ = 0;
    BrushMode mode_ = BrushMode::away;
    int chosen_ = 0;
    int gone_ = 0;                 // it was chosen when it was taken back; 0: none
    std::optional<TreeEdit> led_;  // the stroke that is being led
    std::size_t changes_ = 0;      // of voxels, by it
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
