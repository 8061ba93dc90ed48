// SPDX-License-Identifier: GPL-3.0-or-later
// Identifies the CT of a case by its content, independent of its path and its patient's name.
#pragma once

#include <string>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// SHA-256 of a CT's content as 64 hexadecimal digits: its size, spacing, origin and axes, rounded
// to a micrometre (axes to a millionth), then its Hounsfield units, all as little-endian integers
// in the order of the voxels. The same for every copy of the series, whatever the names of its
// folder and files and its other tags.
std::string digest_of(const Volume& ct);
// The same; reports progress. Throws Cancelled.
std::string digest_of(const Volume& ct, Job& job);

}  // namespace hepatica
