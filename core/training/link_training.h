// SPDX-License-Identifier: GPL-3.0-or-later
// A model of links learned on randomised synthetic patients alone.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/links/link_model.h"

namespace hepatica {

struct TrainingOptions {
    std::uint64_t seed = 1;  // 1 to 10^12; patients of other seeds are others
    int volumes = 60;        // patients, 1 to 10000; about 20 s each
};

// The same options give the same model, whatever the number of threads. One stage a patient. Throws
// InputError for options outside their range, or where the patients taught nothing; Cancelled.
LinkModel trained_links(const TrainingOptions& options, Job& job);

// The number of a patient of a training, for random_patient(): never one of another seed's, nor one
// below a million, which are for judging.
std::uint64_t patient_number(std::uint64_t seed, int volume);

}  // namespace hepatica
