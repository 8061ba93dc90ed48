// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kept_play.h"

#include <utility>

namespace hepatica {
namespace {

bool has_happened(const Frame& frame) {
    return frame.drug.injection != nullptr || frame.drug.computing ||
           (frame.tear && (frame.tear->joints_broken > 0 || frame.tear->entropy_produced_nats > 0));
}

}  // namespace

void KeptPlay::take(std::unique_ptr<Simulation> play, Shown shown) {
    play->update_frame();
    const Frame& last = play->frame();
    const bool as_given = play.get() == std::exchange(given_, nullptr) && last.step == step_;
    if (!has_happened(last)) return;
    if (!as_given) goes_on_ = !last.statistics.paused;
    play->on_frame([] {});  // the window shows others
    // The frame need not show yet what was taken hold of just now.
    for (const Command& put_away :
         {Command(ReleaseGrab{}), Command(RemoveTool{}), Command(UseTools{false})})
        play->post(put_away);
    play->post(SetPaused{true});
    play_ = std::move(play);
    ++number_;
    shown_ = std::move(shown);
}

std::unique_ptr<Simulation> KeptPlay::give_back(const std::string& back_end) {
    if (play_ && back_end != shown_.back_end) drop();
    if (!play_) return nullptr;
    given_ = play_.get();
    step_ = play_->frame().step;
    if (goes_on_) play_->post(SetPaused{false});
    return std::move(play_);
}

}  // namespace hepatica
