// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the haptic loop keeps its rate: a simulated device leads forceps that hold a
// vessel, a thousand times a second on its own thread, while the play runs beside it.
#pragma once

#include <memory>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

struct HapticStudyOptions {
    double seconds = 10.0;  // measured, > 0
    int threads = 1;        // of the play
};

struct HapticStudy {
    int periods = 0;
    // Share of periods with less than a millisecond of the loop's processor time; goal: 0.999.
    double in_time = 0.0;
    // Processor time of a period: model, force, passivity, simulated device, waking and sleeping.
    double median_us = 0.0, p999_us = 0.0, longest_us = 0.0;
    int late = 0;           // periods that began more than 2 ms after the one before, by wall time
    double contacts = 0.0;  // median, of the local model
    int contacts_most = 0;
    double full = 0.0;     // share of periods with most_local_contacts or more
    double work_nj = 0.0;  // done by the loop on the hand
    int steps = 0;         // of the play
    double step_ms = 0.0;  // median step of the play
    int tetrahedra = 0;
};

// Measures on this patient, or on a built-in tree where it is null. Begins two stages of the job.
// Throws InputError where the forceps find no place, Cancelled.
HapticStudy study_haptics(std::shared_ptr<const PatientCase> patient,
                          const HapticStudyOptions& options, Job& job);

}  // namespace hepatica
