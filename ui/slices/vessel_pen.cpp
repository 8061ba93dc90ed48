// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/vessel_pen.h"

namespace hepatica {

void VesselPen::set_taken(bool taken) {
    taken_ = taken;
    places_mm_.clear();
    tell();
}

void VesselPen::add(const Vec3& place_mm) {
    places_mm_.push_back(place_mm);
    tell();
}

void VesselPen::remove_last() {
    if (!places_mm_.empty()) places_mm_.pop_back();
    tell();
}

void VesselPen::give_up() {
    set_taken(!places_mm_.empty());
}

std::string VesselPen::finish() {
    if (places_mm_.size() < 2) return "A vessel needs two places at least: click on the next one";
    if (!draw_) return {};
    const Answer answer = draw_(places_mm_);
    if (answer.drawn) places_mm_.clear();
    tell();
    return answer.text;
}

void VesselPen::tell() const {
    for (const auto& watcher : watchers_) watcher();
}

}  // namespace hepatica
