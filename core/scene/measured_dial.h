// SPDX-License-Identifier: GPL-3.0-or-later
// The dial of a scene: settings with their measured cost and error, on the patient's own body where
// that was done (core/study/dial_study.h, `hepatica-cli dial CASE`), otherwise on a small synthetic
// patient's; the points' reference says which. Points measured on a device stand beside the
// processor's and are used on that device only.
#pragma once

#include <string>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

// The settings for this back end. Throws InputError where the case's dial is damaged. A dial that
// was measured on another mesh, by an older version or not with this back end is ignored. A setting
// with an error above half of the motion is left out if there is a better one.
QualityDial dial_of(const PatientCase& patient, const DeformBackEnd& back_end = cpu_back_end());

// All points of the case's dial, for every back end and without filtering; none where dial_of()
// ignores the dial. Points of older programs are the processor's. Throws InputError as dial_of().
std::vector<QualityPoint> measured_points(const PatientCase& patient);
// The points that a back end can use, with the options to give to it: its own and, where it stands
// beside the processor, also the processor's. None where it has none of its own.
std::vector<QualityPoint> points_for(const DeformBackEnd& back_end,
                                     const std::vector<QualityPoint>& measured);
// Whether a point was measured with exactly this back end and device.
bool is_measured_with(const DeformBackEnd& back_end, const QualityPoint& point);
// Says in words that settings of other devices are left out. Empty where there are none.
std::string words_on_left_out(const DeformBackEnd& back_end,
                              const std::vector<QualityPoint>& measured);
// Without the settings whose elements or solver cannot tear. Throws InputError where none is left.
QualityDial dial_that_tears(const QualityDial& dial);
// The dial of these points; there must be at least one.
QualityDial dial_of_points(std::vector<QualityPoint> points);

// The dial of the small synthetic patient, with costs proportional to the tetrahedra.
QualityDial built_in_dial(std::size_t tetrahedra);

// Whether an error with this reference was measured on the patient's own body, not on the small
// synthetic one. Errors of different bodies cannot be compared.
bool is_of_own_body(const std::string& reference);

// The content of PatientCase::dial_json: points of the patient's own mesh, with their reference.
std::string dial_json(const std::vector<QualityPoint>& points, const PatientCase& patient);

}  // namespace hepatica
