// SPDX-License-Identifier: GPL-3.0-or-later
// Which pairs of patches do not count as touching each other from the beginning: those whose
// triangles are nearer than a gap in the shape at rest. These are neighbours along the surface,
// and branches that nearly touch or overlap where they were meshed.
#pragma once

#include <array>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

// Thread safety: const access only.
class RestPairs {
  public:
    // `candidates`: pairs (a < b) of patches, at least all whose boxes at rest, each grown by half
    // of gap_mm >= 0, meet.
    RestPairs(const SurfacePatches& patches, std::span<const Vec3> rest_positions_mm,
              std::span<const std::array<int, 2>> candidates, double gap_mm);

    // A patch and itself are always left out.
    bool left_out(int patch, int other) const;
    // Ascending, (a < b).
    const std::vector<std::array<int, 2>>& pairs() const { return pairs_; }

  private:
    std::vector<std::array<int, 2>> pairs_;
};

}  // namespace hepatica
