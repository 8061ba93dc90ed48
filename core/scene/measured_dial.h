// SPDX-License-Identifier: GPL-3.0-or-later
// The dial as a scene knows it: settings with the cost and the error that were measured for them,
// on the patient's own body where that was done (core/study/dial_study.h, `hepatica-cli dial
// CASE`), on a small synthetic patient's otherwise. The points' reference says which.
#pragma once

#include <string>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Throws InputError where the case holds a dial that is damaged. A dial that was measured on
// another mesh than the case's, or by an older program in another way, is left aside. A setting
// that misses more than half of the motion is on no dial where there is a better one.
QualityDial dial_of(const PatientCase& patient);

// All points of the dial that the case holds, on a dial or not; none where dial_of() leaves it
// aside. Throws InputError likewise.
std::vector<QualityPoint> measured_points(const PatientCase& patient);
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
