// SPDX-License-Identifier: GPL-3.0-or-later
// Places along a vessel that a person draws into the slices, from its beginning to its end. No
// widget; what becomes of the places is somebody else's (core/tree/editing/vessel_tracing.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// UI thread.
class VesselPen {
  public:
    // What to tell the person of a vessel that was drawn, and whether there is one now: if not, its
    // places stay to be changed.
    struct Answer {
        bool drawn = false;
        std::string text;
    };
    using Draw = std::function<Answer(const std::vector<Vec3>& places_mm)>;

    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }
    void on_draw(Draw draw) { draw_ = std::move(draw); }

    // Whether places are for it. Either way what is half drawn is dropped.
    void set_taken(bool taken);
    bool taken() const { return taken_; }

    void add(const Vec3& place_mm);
    void remove_last();
    // Drops the places; where there are none, puts the pen away.
    void give_up();
    // Draws, from two places on; returns what to tell the person.
    std::string finish();

    const std::vector<Vec3>& places_mm() const { return places_mm_; }

  private:
    void tell() const;

    Draw draw_;
    bool taken_ = false;
    std::vector<Vec3> places_mm_;
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
