// SPDX-License-Identifier: GPL-3.0-or-later
// The fully parallel thinning of Ma and Sonka (1996) with the correction of Wang and Basu (2007):
// voxels that match one of 62 deleting templates are removed simultaneously. Here the axis
// neighbour of the class D templates must obey the distance-2 rule as well; without that, the
// transcribed templates change the topology of one random volume in ten. See thinning_templates.h.
#pragma once

#include "core/base/job.h"
#include "core/skeleton/padded_object.h"

namespace hepatica {

// Deletes until no template matches. Lines may stay two voxels wide in places. Throws Cancelled.
void thin_by_templates(PaddedObject& object, Job& job);

}  // namespace hepatica
