// SPDX-License-Identifier: GPL-3.0-or-later
// Multi-scale vesselness: how much a neighbourhood looks like a bright tube, from the eigenvalues
// of the Hessian (Sato 1998; Frangi 1998; the ratio form of Jerman 2016, flat inside vessels).
#pragma once

#include <array>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Symmetric 3 x 3: xx, yy, zz, xy, xz, yz.
using Symmetric3 = std::array<float, 6>;

// In closed form, ascending. Accurate to 1e-5 of the largest magnitude.
std::array<float, 3> eigenvalues(const Symmetric3& matrix);

// The response at one scale is the mean of the two strongest negative curvatures, in HU, scale
// normalised by sigma^2; it is 0 where either of them is not negative, and reduced for blobs.
// Returns the largest response over the scales. The grid must be isotropic to 1 %.
FloatVolume vesselness(const FloatVolume& intensity, const std::vector<double>& sigmas_mm,
                       Job& job);

}  // namespace hepatica
