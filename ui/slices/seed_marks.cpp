// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/seed_marks.h"

#include <utility>

namespace hepatica {

void SeedMarks::take(std::optional<VascularSystem> system) {
    if (taken_ == system) return;
    taken_ = system;
    watchers_.tell();
}

void SeedMarks::add(const Vec3& position_mm) {
    if (!taken_) return;
    seeds_.push_back({position_mm, *taken_});
    watchers_.tell();
}

void SeedMarks::remove_last() {
    if (seeds_.empty()) return;
    seeds_.pop_back();
    watchers_.tell();
}

void SeedMarks::clear() {
    if (!taken_ && seeds_.empty() && of_case_.empty()) return;
    taken_.reset();
    seeds_.clear();
    of_case_.clear();
    watchers_.tell();
}

void SeedMarks::show(std::vector<VesselSeed> of_case) {
    seeds_ = of_case_ = std::move(of_case);
    watchers_.tell();
}

}  // namespace hepatica
