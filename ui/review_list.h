// SPDX-License-Identifier: GPL-3.0-or-later
// What happened in a play, in a second one beside it, and the notes, in the order of time: a line
// each, and the ticks of the same colours for a time line.
#pragma once

#include <QListWidget>
#include <optional>
#include <vector>

#include "core/lesson/play_events.h"
#include "core/lesson/play_notes.h"
#include "ui/time_line.h"

namespace hepatica {

class ReviewList : public QListWidget {
  public:
    explicit ReviewList(QWidget* parent = nullptr);

    // Shows these; nothing is chosen then. Does nothing where they are those that it shows.
    void fill(std::vector<PlayEvent> events, std::vector<PlayEvent> beside,
              std::vector<PlayNote> notes);
    const std::vector<TimeLine::Tick>& ticks() const { return ticks_; }

    double at_s(int row) const;
    // Which of the notes the row is; none where it is something that happened.
    std::optional<std::size_t> note(int row) const;
    // The row of what happens next after a moment (+1), or happened last before it (-1); -1: none.
    int next_row(double at_s, int direction) const;

  private:
    std::vector<PlayEvent> events_, beside_;
    std::vector<PlayNote> notes_;
    std::vector<TimeLine::Tick> ticks_;
};

}  // namespace hepatica
