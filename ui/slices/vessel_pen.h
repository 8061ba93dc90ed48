// SPDX-License-Identifier: GPL-3.0-or-later
// The places along a vessel that the user draws into the slices, from its beginning to its end. No
// widgets; core/tree/editing/vessel_tracing.h makes the vessel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"
#include "ui/slices/watchers.h"

namespace hepatica {

// UI thread only.
class VesselPen {
  public:
    // Whether the vessel was drawn, and the message for the user. If it was not, its places stay to
    // be changed.
    struct Answer {
        bool drawn = false;
        std::string text;
    };
    using Answered = std::function<void(const Answer&)>;
    // `begin` draws in the background and answers once, immediately or later; not after `stop`,
    // which cancels it.
    struct Drawing {
        std::function<void(const std::vector<Vec3>& places_mm, Answered)> begin;
        std::function<void()> stop = [] {};
    };

    static constexpr double least_mm = 0.5, most_mm = 15.0;

    // Called after every change.
    void on_change(std::function<void()> tell) { watchers_.add(std::move(tell)); }
    void on_draw(Drawing drawing) { drawing_ = std::move(drawing); }
    // Receives messages for the user.
    void on_say(std::function<void(const std::string&)> say) { say_ = std::move(say); }

    // Whether clicks set places of a vessel. Both drop an unfinished vessel.
    void set_taken(bool taken);
    bool taken() const { return taken_; }

    // Radius of the vessels to be drawn, clamped to [least_mm, most_mm]; nullopt: as the CT shows
    // it. Kept from vessel to vessel.
    void set_radius(const std::optional<double>& radius_mm);
    const std::optional<double>& radius_mm() const { return radius_mm_; }

    // No effect while a vessel is being drawn.
    void add(const Vec3& place_mm);
    void remove_last();
    // Cancels the drawing; else drops the places; if there are none, puts the pen away.
    void give_up();
    // Draws the vessel; needs two places or more.
    void finish();
    bool draws() const { return draws_; }

    const std::vector<Vec3>& places_mm() const { return places_mm_; }

  private:
    void stop();
    void take(const Answer& answer);

    Drawing drawing_;
    std::function<void(const std::string&)> say_ = [](const std::string&) {};
    bool taken_ = false;
    bool draws_ = false;
    std::optional<double> radius_mm_;
    std::vector<Vec3> places_mm_;
    Watchers watchers_;
};

}  // namespace hepatica
