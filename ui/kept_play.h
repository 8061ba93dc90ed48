// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a free play with tears or an injection while a lesson or a review is shown in its place, so
// that nobody loses by looking at something else what he has done.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "ui/quality_panel.h"
#include "ui/simulation.h"
#include "ui/tear_history.h"

namespace hepatica {

// UI thread only.
class KeptPlay {
  public:
    // What the window shows of a play besides its frames.
    struct Shown {
        std::string back_end;            // a name of BackEnds
        QualityPanel::Choices settings;  // what acts on it
        TearHistory tears;
    };

    // The play stands still from now on, and nothing is held or touched by tools in it. One in
    // which nothing has torn and nothing was injected ends.
    void take(std::unique_ptr<Simulation> play, Shown shown);
    // The play that was taken, which goes on if it did. Null where there is none, or where another
    // back end was chosen since: it then ends.
    std::unique_ptr<Simulation> give_back(const std::string& back_end);
    // Of the play that was given back last.
    const Shown& shown() const { return shown_; }
    void drop() { play_.reset(); }
    // Which play is kept, as a number that no other one has; nullopt: none.
    std::optional<int> kept() const { return play_ ? std::optional(number_) : std::nullopt; }
    // A dial of this back end.
    void use_dial(const QualityDial& dial, const std::string& back_end) {
        if (play_ && back_end == shown_.back_end) play_->use_dial(dial);
    }

  private:
    std::unique_ptr<Simulation> play_;
    Shown shown_;
    int number_ = 0;  // of the play that was taken last
    bool goes_on_ = false;
    const Simulation* given_ = nullptr;  // back, and perhaps not gone on yet
    std::uint64_t step_ = 0;             // of its frame then
};

}  // namespace hepatica
