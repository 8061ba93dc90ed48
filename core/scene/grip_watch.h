// SPDX-License-Identifier: GPL-3.0-or-later
// Notices what forceps do: that they close on a vessel or on nothing, because they closed beside it
// or it slipped out, and that they open.
#pragma once

#include <utility>

#include "core/scene/frame.h"

namespace hepatica {

class GripWatch {
  public:
    enum class Seen { nothing_new, closed_on_something, closed_on_nothing, slipped, opened };

    // Takes the forceps of the newest frame and whether the jaws are commanded to close. Each
    // closing is reported once: as soon as something is held, or where the jaws have met without.
    // Until then a vessel may still come between them.
    Seen see(const ToolView& forceps, bool closed);

  private:
    bool closed_ = false;
    bool held_ = false;  // held something since they began to close
    bool told_ = false;  // that they hold nothing
};

inline GripWatch::Seen GripWatch::see(const ToolView& forceps, bool closed) {
    constexpr double met_mm = 0.05;
    const bool was_closed = std::exchange(closed_, closed);
    if (!closed) {
        held_ = told_ = false;
        return was_closed ? Seen::opened : Seen::nothing_new;
    }
    if (forceps.grip_un > 0.0) {
        told_ = false;
        return std::exchange(held_, true) ? Seen::nothing_new : Seen::closed_on_something;
    }
    if (told_ || forceps.opening_mm > met_mm) return Seen::nothing_new;
    told_ = true;
    return std::exchange(held_, false) ? Seen::slipped : Seen::closed_on_nothing;
}

}  // namespace hepatica
