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
    using Answered = std::function<void(const Answer&)>;
    // Draws beside the window, and answers once, at once or later; not after `stop`, which ends
    // what is being drawn.
    struct Drawing {
        std::function<void(const std::vector<Vec3>& places_mm, Answered)> begin;
        std::function<void()> stop = [] {};
    };

    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }
    void on_draw(Drawing drawing) { drawing_ = std::move(drawing); }
    // What to tell the person.
    void on_say(std::function<void(const std::string&)> say) { say_ = std::move(say); }

    // Whether places are for it. Either way what is half drawn is dropped.
    void set_taken(bool taken);
    bool taken() const { return taken_; }

    // While a vessel is being drawn its places stay as they are.
    void add(const Vec3& place_mm);
    void remove_last();
    // Ends what is being drawn; else drops the places; where there are none, puts the pen away.
    void give_up();
    // Draws, from two places on.
    void finish();
    bool draws() const { return draws_; }

    const std::vector<Vec3>& places_mm() const { return places_mm_; }

  private:
    void tell() const;
    void stop();
    void take(const Answer& answer);

    Drawing drawing_;
    std::function<void(const std::string&)> say_ = [](const std::string&) {};
    bool taken_ = false;
    bool draws_ = false;
    std::vector<Vec3> places_mm_;
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
