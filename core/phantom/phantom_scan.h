// SPDX-License-Identifier: GPL-3.0-or-later
// Imaging of the phantom: the share of each voxel that is lumen, counted on 4 x 4 x 4 points, and
// from it a CT with the scanner's point spread and noise.
#pragma once

#include <optional>

#include "core/phantom/phantom.h"
#include "core/phantom/phantom_body.h"

namespace hepatica {

// Sixty-fourths of each voxel that lie inside a vessel of the given system (none: of any). A vessel
// is the union of the cones between its points, closed by half balls at its ends.
Image<std::uint8_t> lumen_share(const VesselTree& tree, const Grid& grid,
                                std::optional<VascularSystem> system, Job& job);

// Fills ct and liver of the phantom, whose tree and vessels are there, and gives each vessel voxel
// the number of the system that fills more of it. `scale` is the size of the
// anatomy relative to an adult's. Two stages.
void scan(Phantom& phantom, const PhantomBody& body, const PhantomOptions& options, double scale,
          Job& job);

}  // namespace hepatica
