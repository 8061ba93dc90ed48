// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a free play with tears or an injection while a lesson or a review is shown in its place, so
// that nobody loses by looking at something else what he has done.
#pragma once

#include <memory>

#include "ui/simulation.h"

namespace hepatica {

// UI thread only.
class KeptPlay {
  public:
    // The play stands still from now on, and nothing is held in it. One in which nothing tears and
    // nothing was injected ends: a new one is the same.
    void take(std::unique_ptr<Simulation> play);
    // The play that was taken, which goes on if it did; null: none.
    std::unique_ptr<Simulation> give_back();
    void drop() { play_.reset(); }
    void use_dial(const QualityDial& dial) {
        if (play_) play_->use_dial(dial);
    }

  private:
    std::unique_ptr<Simulation> play_;
    bool went_on_ = false;
};

}  // namespace hepatica
