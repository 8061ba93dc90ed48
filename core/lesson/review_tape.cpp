// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/review_tape.h"

#include <algorithm>
#include <utility>

namespace hepatica {

namespace {

// Memory owned by the frame alone; triangles and arrival times are shared.
std::size_t bytes_of(const Frame& frame) {
    std::size_t bytes = sizeof(Frame) + frame.positions_mm.size() * sizeof(float);
    if (frame.tool) bytes += frame.tool->touched.size() * sizeof(int);
    if (frame.tear && frame.tear->loads) bytes += frame.tear->loads->size() * sizeof(float);
    return bytes;
}

}  // namespace

ReviewTape::ReviewTape(std::size_t most_bytes) : most_bytes_(most_bytes) {}

void ReviewTape::add(double at_s, Frame frame) {
    const std::lock_guard lock(mutex_);
    const bool same_time = !kept_.empty() && kept_.back().at_s == at_s;
    if (same_time) --frames_;
    // The newest frame is always kept; the next one replaces it unless its number fits the stride.
    if (same_time || (!kept_.empty() && !stays(kept_.back()))) {
        bytes_ -= bytes_of(*kept_.back().frame);
        kept_.pop_back();
    }
    bytes_ += bytes_of(frame);
    kept_.push_back({at_s, frames_++, std::make_shared<const Frame>(std::move(frame))});
    while (bytes_ > most_bytes_ && kept_.size() > 2) keep_half();
}

void ReviewTape::keep_half() {
    stride_ *= 2;
    std::vector<Kept> fewer;
    bytes_ = 0;
    for (Kept& one : kept_) {
        if (!stays(one) && &one != &kept_.back()) continue;
        bytes_ += bytes_of(*one.frame);
        fewer.push_back(std::move(one));
    }
    kept_ = std::move(fewer);
}

void ReviewTape::note(PlayEvent event) {
    const std::lock_guard lock(mutex_);
    const auto later = std::ranges::upper_bound(events_, event.at_s, {}, &PlayEvent::at_s);
    events_.insert(later, std::move(event));
}

std::shared_ptr<const Frame> ReviewTape::at(double at_s) const {
    const std::lock_guard lock(mutex_);
    if (kept_.empty()) return nullptr;
    const auto later = std::ranges::upper_bound(kept_, at_s, {}, &Kept::at_s);
    return (later == kept_.begin() ? later : later - 1)->frame;
}

double ReviewTape::end_s() const {
    const std::lock_guard lock(mutex_);
    return kept_.empty() ? 0.0 : kept_.back().at_s;
}

std::vector<PlayEvent> ReviewTape::events() const {
    const std::lock_guard lock(mutex_);
    return events_;
}

std::size_t ReviewTape::size() const {
    const std::lock_guard lock(mutex_);
    return kept_.size();
}

}  // namespace hepatica
