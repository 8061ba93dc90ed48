// SPDX-License-Identifier: GPL-3.0-or-later
// A point that moves to its target over some time instead of at once. Mouse positions arrive only
// once per picture: the vessel would jerk at every report and rest in between, which costs the
// solver two or three times as much as the hand's even motion.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/vector.h"

namespace hepatica {

class LedPoint {
  public:
    // From its position at the next step, the point moves evenly to the target in `over_s`.
    void lead_to(const Vec3& target_mm, double over_s) { way_ = Way{target_mm, over_s}; }
    void stay() { way_.reset(); }
    bool underway() const { return way_.has_value(); }

    // The position `dt_s` after it was at `at_mm`. Requires underway().
    Vec3 next(const Vec3& at_mm, double dt_s) {
        const Way way = *way_;
        constexpr double rounding = 1e-9;  // of the remaining time, after many steps
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
