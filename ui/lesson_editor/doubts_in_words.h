// SPDX-License-Identifier: GPL-3.0-or-later
// The messages below the lesson editor's pages: what is missing and what is doubtful.
#pragma once

#include <QString>

#include "core/lesson/lesson.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Whether the lesson is for the shown patient; true for a lesson for any patient. `shown` as in
// doubts_in_words().
bool is_for_shown(const Lesson& lesson, const QString& shown);

// One line each, gaps first, at most four lines; empty if nothing is missing or doubtful. `patient`
// is the shown patient, null for none; `shown` is his name in a lesson, empty if he has no place on
// disk.
QString doubts_in_words(const Lesson& lesson, const PatientCase* patient, const QString& shown);

}  // namespace hepatica
