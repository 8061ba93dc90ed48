// SPDX-License-Identifier: GPL-3.0-or-later
// Multi-scale vesselness: how much a neighbourhood looks like a bright tube, from the eigenvalues
// of the Hessian (Sato et al. 1998, with the blob term of Frangi et al. 1998).
#pragma once

#include <array>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Symmetric 3 x 3: xx, yy, zz, xy, xz, yz.
using Symmetric3 = std::array<float, 6>;

// Eigenvalues in closed form, ascending. Accurate to 1e-5 of the largest magnitude.
std::array<float, 3> eigenvalues(const Symmetric3& matrix);

// The response at one scale is the weaker of the two cross-sectional curvatures in HU, times
// sigma^2 so that scales compare, lowered for blobs; 0 where the centre is no brighter than its
// surroundings and at the border. Returns the largest response over the scales. Throws InputError
// where the voxels are not cubes to 1 % or a scale is below half a voxel; Cancelled.
FloatVolume vesselness(const FloatVolume& intensity, const std::vector<double>& sigmas_mm,
                       Job& job);

}  // namespace hepatica
