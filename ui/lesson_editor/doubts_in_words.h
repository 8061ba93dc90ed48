// SPDX-License-Identifier: GPL-3.0-or-later
// What the lesson editor says below its pages: what is missing and what can hardly be meant.
#pragma once

#include <QString>

#include "core/lesson/lesson.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Whether a lesson is for who is shown: `shown` as in doubts_in_words(). One for any is.
bool is_for_shown(const Lesson& lesson, const QString& shown);

// A line each, the gaps first, of many the first ones; empty: nothing is missing or doubtful.
// `patient`: who is shown, null: none; `shown`: as a lesson names him, empty: he lies nowhere.
QString doubts_in_words(const Lesson& lesson, const PatientCase* patient, const QString& shown);

}  // namespace hepatica
