// SPDX-License-Identifier: GPL-3.0-or-later
// Notices closing forceps that hold nothing, because they closed beside the vessel or it slipped
// out.
#pragma once

#include "core/scene/frame.h"

namespace hepatica {

class GripWatch {
  public:
    enum class Seen { nothing_new, closed_on_nothing, slipped };

    // Takes the forceps of the newest frame and whether the jaws are commanded to close. Each
    // closing is reported once, when the jaws have met: until then a vessel may still come between
    // them.
    Seen see(const ToolView& forceps, bool closed);

  private:
    bool held_ = false;  // held something since they began to close
    bool told_ = false;
};

inline GripWatch::Seen GripWatch::see(const ToolView& forceps, bool closed) {
    constexpr double met_mm = 0.05;
    if (!closed) {
        held_ = told_ = false;
        return Seen::nothing_new;
    }
    if (forceps.grip_un > 0.0) {
        held_ = true;
        told_ = false;
        return Seen::nothing_new;
    }
    if (told_ || forceps.opening_mm > met_mm) return Seen::nothing_new;
    told_ = true;
    const bool slipped = held_;
    held_ = false;
    return slipped ? Seen::slipped : Seen::closed_on_nothing;
}

}  // namespace hepatica
