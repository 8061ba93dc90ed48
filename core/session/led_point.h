// SPDX-License-Identifier: GPL-3.0-or-later
// A point that goes to where it is led over some time instead of at once. A mouse is heard only
// between two pictures: the vessel would be jerked at every report and held still in between, which
// costs the solver two or three times as much as the even motion of the hand that leads the mouse.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/vector.h"

namespace hepatica {

class LedPoint {
  public:
    // From where it is then, it goes to the target in `over_s`, evenly.
    void lead_to(const Vec3& target_mm, double over_s) { way_ = Way{target_mm, over_s}; }
    void stay() { way_.reset(); }
    bool underway() const { return way_.has_value(); }

    // Where it is `dt_s` after it was at `at_mm`. Only while it is under way.
    Vec3 next(const Vec3& at_mm, double dt_s) {
        const Way way = *way_;
        constexpr double rounding = 1e-9;  // of what is left, after many steps
        if (dt_s >= (1.0 - rounding) * way.left_s) {
            way_.reset();
            return way.target_mm;
        }
        way_->left_s -= dt_s;
        return at_mm + dt_s / way.left_s * (way.target_mm - at_mm);
    }

  private:
    struct Way {
        Vec3 target_mm;
        double left_s;
    };
    std::optional<Way> way_;
};

}  // namespace hepatica
