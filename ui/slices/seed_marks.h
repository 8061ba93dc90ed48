// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds that are set by clicks in the slices: places in vessels of which the user says to which
// system they belong. The next reconstruction begins with them. No widgets.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/vascular_system.h"
#include "ui/slices/watchers.h"

namespace hepatica {

// UI thread only.
class SeedMarks {
  public:
    // Called after every change.
    void on_change(std::function<void()> tell) { watchers_.add(std::move(tell)); }
    // What reconstructs the CT with the seeds.
    void on_reconstruct(std::function<void()> begin) { reconstruct_ = std::move(begin); }

    // The system of the next seed; nullopt: clicks set none. Seeds that are set stay.
    void take(std::optional<VascularSystem> system);
    const std::optional<VascularSystem>& taken() const { return taken_; }

    // No effect where none is taken.
    void add(const Vec3& position_mm);
    void remove_last();
    void clear();
    // Those that the shown case was made with, in place of all.
    void show(std::vector<VesselSeed> of_case);
    // Whether other seeds are set than the shown case was made with.
    bool changed() const { return seeds_ != of_case_; }
    void reconstruct() const { reconstruct_(); }

    // In the order in which they were set.
    const std::vector<VesselSeed>& seeds() const { return seeds_; }

  private:
    std::function<void()> reconstruct_ = [] {};
    std::optional<VascularSystem> taken_;
    std::vector<VesselSeed> seeds_, of_case_;
    Watchers watchers_;
};

}  // namespace hepatica
