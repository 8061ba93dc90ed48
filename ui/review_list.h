// SPDX-License-Identifier: GPL-3.0-or-later
// List of the events of a play, of a second one beside it, and of notes, in chronological order,
// and the ticks of the same colours for a time line.
#pragma once

#include <QListWidget>
#include <optional>
#include <vector>

#include "core/lesson/play_events.h"
#include "core/lesson/play_notes.h"
#include "ui/time_line.h"

namespace hepatica {

// UI thread only.
class ReviewList : public QListWidget {
  public:
    explicit ReviewList(QWidget* parent = nullptr);

    // Shows these, with no row selected. No effect if they are shown already.
    void fill(std::vector<PlayEvent> events, std::vector<PlayEvent> beside,
              std::vector<PlayNote> notes);
    const std::vector<TimeLine::Tick>& ticks() const { return ticks_; }

    double at_s(int row) const;
    // Index of the row's note; nullopt if it is an event.
    std::optional<std::size_t> note(int row) const;
    // Row of the next event after a moment (+1) or the last one before it (-1); -1: none.
    int next_row(double at_s, int direction) const;

  private:
    std::vector<PlayEvent> events_, beside_;
    std::vector<PlayNote> notes_;
    std::vector<TimeLine::Tick> ticks_;
};

}  // namespace hepatica
