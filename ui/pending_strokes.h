// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes at the vessels' voxels that wait for the vessels to be made anew of them, each with its
// place among the corrections, so that one order of undo holds for both. A value: it can be kept
// and shown again. No toolkit; not thread-safe.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/patient/pending_stroke.h"

namespace hepatica {

// `edits`: how many corrections are wanted now.
class PendingStrokes {
  public:
    PendingStrokes() = default;
    explicit PendingStrokes(std::vector<PendingStroke> made) : made_(std::move(made)) {}

    const std::vector<PendingStroke>& made() const { return made_; }
    bool empty() const { return made_.empty(); }

    void add(const BrushStroke& stroke, std::size_t edits) {
        undone_.clear();
        made_.push_back({stroke, edits});
    }
    // Whether the last thing that was done, or taken back, is a stroke and no correction.
    bool undo_is_mine(std::size_t edits) const {
        return !made_.empty() && made_.back().after_edits >= edits;
    }
    bool redo_is_mine(std::size_t edits) const {
        return !undone_.empty() && undone_.back().after_edits <= edits;
    }
    // The last stroke; nothing where there is none.
    void undo() { move_last(made_, undone_); }
    void redo() { move_last(undone_, made_); }
    // What redo would lead again; there must be one.
    const BrushStroke& next_again() const { return undone_.back().stroke; }
    void forget_undone() { undone_.clear(); }

    // The first so many are in the vessels now; the others come after these corrections. Returns
    // those that are.
    std::vector<PendingStroke> take_first(std::size_t count, std::size_t edits) {
        const auto end = made_.begin() + static_cast<std::ptrdiff_t>(std::min(count, made_.size()));
        std::vector<PendingStroke> taken(made_.begin(), end);
        made_.erase(made_.begin(), end);
        for (PendingStroke& left : made_) left.after_edits = std::min(left.after_edits, edits);
        undone_.clear();
        return taken;
    }
    // Before those that are there, as take_first() gave them.
    void put_back(const std::vector<PendingStroke>& taken) {
        made_.insert(made_.begin(), taken.begin(), taken.end());
        undone_.clear();
    }

  private:
    static void move_last(std::vector<PendingStroke>& from, std::vector<PendingStroke>& to) {
        if (from.empty()) return;
        to.push_back(std::move(from.back()));
        from.pop_back();
    }

    std::vector<PendingStroke> made_;
    std::vector<PendingStroke> undone_;  // the last one is the first to be done again
};

}  // namespace hepatica
