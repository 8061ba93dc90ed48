// SPDX-License-Identifier: GPL-3.0-or-later
// Learns a model of links on randomised synthetic patients alone.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/links/link_model.h"

namespace hepatica {

struct TrainingOptions {
    std::uint64_t seed = 1;  // 1 to 10^12; other seeds give other patients
    int volumes = 60;        // number of patients, 1 to 10000; about 20 s each
};

// Trains a model. The same options give the same model for any number of threads. Begins one stage
// for each patient and one for the forest. Throws InputError for options outside their range, or
// where the patients gave fewer than 200 pieces; Cancelled.
LinkModel trained_links(const TrainingOptions& options, Job& job);

// The number of a training patient for random_patient(). Numbers of different seeds differ, and
// those below a million are left for tests.
std::uint64_t patient_number(std::uint64_t seed, int volume);

}  // namespace hepatica
