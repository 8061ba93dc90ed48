// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes at the vessel mask that wait for a rebuild, each with its place among the corrections, so
// that both share one order of undo. A value type. No widgets; not thread-safe.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/patient/pending_stroke.h"

namespace hepatica {

// `edits`: number of the present corrections.
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
    // Whether the last step to undo, or the next to redo, is a stroke and not a correction.
    bool undo_is_mine(std::size_t edits) const {
        return !made_.empty() && made_.back().after_edits >= edits;
    }
    bool redo_is_mine(std::size_t edits) const {
        return !undone_.empty() && undone_.back().after_edits <= edits;
    }
    // Both have no effect if there is no stroke.
    void undo() { move_last(made_, undone_); }
    void redo() { move_last(undone_, made_); }
    // The stroke that redo() would restore; there must be one.
    const BrushStroke& next_again() const { return undone_.back().stroke; }
    void forget_undone() { undone_.clear(); }

    // Removes and returns the first `count` strokes, which are in the vessels now; the others
    // follow `edits` corrections.
    std::vector<PendingStroke> take_first(std::size_t count, std::size_t edits) {
        const auto end = made_.begin() + static_cast<std::ptrdiff_t>(std::min(count, made_.size()));
        std::vector<PendingStroke> taken(made_.begin(), end);
        made_.erase(made_.begin(), end);
        for (PendingStroke& left : made_) left.after_edits = std::min(left.after_edits, edits);
        undone_.clear();
        return taken;
    }
    // Inserts strokes from take_first() before the present ones.
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
    std::vector<PendingStroke> undone_;  // the last one is redone first
};

}  // namespace hepatica
