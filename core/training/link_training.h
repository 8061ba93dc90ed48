// SPDX-License-Identifier: GPL-3.0-or-later
// Learns a model of links on randomised synthetic patients alone.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/error.h"
#include "core/base/job.h"
#include "core/links/link_model.h"
#include "core/training/taught_pieces.h"

namespace hepatica {

struct TrainingOptions {
    std::uint64_t seed = 1;  // 1 to 10^12; other seeds give other patients
    int volumes = 60;        // number of patients, 1 to 10000; about 20 s each
};

// What a patient teaches, as taught_by().
using Teacher =
    std::function<std::vector<TaughtPiece>(std::uint64_t number, double line_share, Job& job)>;
// Told of each patient that is left out, with the reason, as soon as it is.
using OnLeftOut = std::function<void(std::uint64_t number, const InputError& reason)>;

// Trains a model. The same options give the same model for any number of threads. Begins one stage
// for each patient and one for the forest. A patient that is refused with an InputError (no liver
// is found in it, for example) is left out. Throws InputError for options outside their range,
// where every patient was refused, or where the others gave fewer than 200 pieces; Cancelled.
LinkModel trained_links(const TrainingOptions& options, Job& job, const OnLeftOut& on_left_out = {},
                        const Teacher& teach = taught_by);

// The number of a training patient for random_patient(). Numbers of different seeds differ, and
// those below a million are left for tests.
std::uint64_t patient_number(std::uint64_t seed, int volume);

}  // namespace hepatica
