// SPDX-License-Identifier: GPL-3.0-or-later
// Imaging of the phantom: the lumen's share of each voxel, counted on 4 x 4 x 4 points, and from it
// a CT with the scanner's point spread and noise.
#pragma once

#include <optional>

#include "core/phantom/phantom.h"
#include "core/phantom/phantom_body.h"

namespace hepatica {

// Sixty-fourths of each voxel that lie inside a vessel of the given system (none: any). A vessel is
// the union of the cones between its points, closed by half balls. The same for any number of
// threads. Throws Cancelled.
Image<std::uint8_t> lumen_share(const VesselTree& tree, const Grid& grid,
                                std::optional<VascularSystem> system, Job& job);

// Fills ct and liver of a phantom that has its tree and vessels, and gives each vessel voxel the
// system that fills more of it. `scale` is the size of the anatomy relative to an adult's. Begins
// two stages; throws Cancelled.
void scan(Phantom& phantom, const PhantomBody& body, const PhantomOptions& options, double scale,
          Job& job);

}  // namespace hepatica
