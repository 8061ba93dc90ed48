// SPDX-License-Identifier: GPL-3.0-or-later
// The dial as a scene knows it: settings with the cost and the error that were measured for them,
// on the patient's own body where that was done (core/study/dial_study.h, `hepatica-cli dial
// CASE`), on a small synthetic patient's otherwise. The points' reference says which. Those that
// were measured on a device stand beside the processor's, and are played on that device alone.
#pragma once

#include <string>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

// The settings that this back end can play. Throws InputError where the case holds a dial that is
// damaged. A dial that was measured on another mesh than the case's, by an older program in another
// way, or not with this back end, is left aside. A setting that misses more than half of the motion
// is on no dial where there is a better one.
QualityDial dial_of(const PatientCase& patient, const DeformBackEnd& back_end = cpu_back_end());

// All points of the dial that the case holds, on a dial or not, of every back end; none where
// dial_of() leaves it aside. Those of older programs are the processor's. Throws InputError
// likewise.
std::vector<QualityPoint> measured_points(const PatientCase& patient);
// Those of them that a back end can play, with options as it is to be given them: its own and,
// where it stands beside the processor, the processor's. None where none of its own is among them.
std::vector<QualityPoint> points_for(const DeformBackEnd& back_end,
                                     const std::vector<QualityPoint>& measured);
// Whether a point was measured with this very back end, on this very device.
bool is_measured_with(const DeformBackEnd& back_end, const QualityPoint& point);
// For a person: that settings of devices are left out which are not this back end's. Empty where
// there are none.
std::string words_on_left_out(const DeformBackEnd& back_end,
                              const std::vector<QualityPoint>& measured);
// Without the settings whose elements or solver cannot follow a tear. Throws InputError where none
// is left.
QualityDial dial_that_tears(const QualityDial& dial);
// The dial of such points, of which there is one or more.
QualityDial dial_of_points(std::vector<QualityPoint> points);

// The small synthetic patient's, with costs in proportion to the tetrahedra.
QualityDial built_in_dial(std::size_t tetrahedra);

// Whether an error with this reference was measured on the patient's own body, and not on the small
// synthetic one: errors of two bodies are no one scale.
bool is_of_own_body(const std::string& reference);

// What PatientCase::dial_json holds: points of the patient's own mesh, with their reference.
std::string dial_json(const std::vector<QualityPoint>& points, const PatientCase& patient);

}  // namespace hepatica
