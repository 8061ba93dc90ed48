// SPDX-License-Identifier: GPL-3.0-or-later
// Dispatch to the two thinning methods.
#include "core/skeleton/thinning.h"

#include "core/skeleton/parallel_thinning.h"
#include "core/skeleton/queue_thinning.h"

namespace hepatica {

Mask thin(const Mask& mask, ThinningMethod method, Job& job) {
    PaddedObject object(mask);
    if (object.empty()) return Mask(mask.grid);
    const JobPart whole(job, 0.0, 1.0);  // a border that grows for a while takes nothing back
    if (method == ThinningMethod::parallel)
        thin_by_templates(object, job);
    else
        thin_by_queue(object, job);
    return object.to_mask();
}

}  // namespace hepatica
