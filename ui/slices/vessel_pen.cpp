// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/vessel_pen.h"

#include <algorithm>

#include "ui/words.h"

namespace hepatica {

void VesselPen::set_taken(bool taken) {
    if (draws_) stop();
    taken_ = taken;
    places_mm_.clear();
    watchers_.tell();
}

void VesselPen::set_radius(const std::optional<double>& radius_mm) {
    radius_mm_ = radius_mm;
    if (radius_mm_) radius_mm_ = std::clamp(*radius_mm_, least_mm, most_mm);
    watchers_.tell();
}

void VesselPen::add(const Vec3& place_mm) {
    if (draws_) return;
    places_mm_.push_back(place_mm);
    watchers_.tell();
}

void VesselPen::remove_last() {
    if (draws_) return;
    if (!places_mm_.empty()) places_mm_.pop_back();
    watchers_.tell();
}

void VesselPen::give_up() {
    if (!draws_) return set_taken(!places_mm_.empty());
    stop();
    watchers_.tell();
    say_(Words::tr("Not drawn: it was stopped. Enter draws it, Escape drops its places")
             .toStdString());
}

void VesselPen::finish() {
    if (draws_ || !drawing_.begin) return;
    if (places_mm_.size() < 2)
        return say_(
            Words::tr("A vessel needs two places at least: click on the next one").toStdString());
    draws_ = true;
    watchers_.tell();
    say_(Words::tr("Following the vessel; Escape stops it").toStdString());
    drawing_.begin(places_mm_, [this](const Answer& answer) { take(answer); });
}

void VesselPen::take(const Answer& answer) {
    draws_ = false;
    if (answer.drawn) places_mm_.clear();
    watchers_.tell();
    say_(answer.text);
}

void VesselPen::stop() {
    drawing_.stop();
    draws_ = false;
}

}  // namespace hepatica
