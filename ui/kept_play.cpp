// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kept_play.h"

#include <utility>

namespace hepatica {

void KeptPlay::take(std::unique_ptr<Simulation> play) {
    const Frame& last = play->frame();
    if (!last.tear && last.drug.injection == nullptr) return;
    play->on_frame([] {});  // the window shows others
    if (last.grab) play->post(ReleaseGrab{});
    if (last.tool) play->post(RemoveTool{});
    went_on_ = !last.statistics.paused;
    play->post(SetPaused{true});
    play_ = std::move(play);
}

std::unique_ptr<Simulation> KeptPlay::give_back() {
    if (play_ && went_on_) play_->post(SetPaused{false});
    return std::move(play_);
}

}  // namespace hepatica
