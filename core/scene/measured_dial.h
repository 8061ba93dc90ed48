// SPDX-License-Identifier: GPL-3.0-or-later
// The dial as a scene knows it: settings with the cost and the error that were measured for them,
// on the patient's own body where `hepatica-cli tradeoff CASE` has left them in the case, on a
// small synthetic patient's otherwise. The points' reference says which.
#pragma once

#include <string>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Throws InputError where the case holds a dial that is damaged. A dial that was measured on
// another mesh than the case's is left aside.
QualityDial dial_of(const PatientCase& patient);

// The small synthetic patient's, with costs in proportion to the tetrahedra.
QualityDial built_in_dial(std::size_t tetrahedra);

// What PatientCase::dial_json holds: points of the patient's own mesh, with their reference.
std::string dial_json(const std::vector<QualityPoint>& points, const PatientCase& patient);

}  // namespace hepatica
