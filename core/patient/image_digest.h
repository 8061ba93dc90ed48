// SPDX-License-Identifier: GPL-3.0-or-later
// Which CT a case was made from, without a word of where it lies or whose it is.
#pragma once

#include <string>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// SHA-256 of a CT's content, 64 hexadecimal digits: its size, spacing, origin and axes, rounded to
// a micrometre (axes to a millionth), then its Hounsfield units, all as little-endian integers in
// the order of the voxels. The same for every copy of the series, whatever its folder, its files
// and its other tags are called or say.
std::string digest_of(const Volume& ct);
// The same; reports progress. Throws Cancelled.
std::string digest_of(const Volume& ct, Job& job);

}  // namespace hepatica
