// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning by a queue of border voxels in six directional sub-iterations (in the manner of Palagyi
// and Kuba 1998). Candidates are chosen together, and each is tested again before it is deleted, so
// the topology is preserved by construction.
#pragma once

#include "core/base/job.h"
#include "core/skeleton/padded_object.h"

namespace hepatica {

// Deletes simple voxels that are not line ends until none is left. Throws Cancelled.
void thin_by_queue(PaddedObject& object, Job& job);

}  // namespace hepatica
