// SPDX-License-Identifier: GPL-3.0-or-later
// What the lesson editor says below its pages: what is missing and what can hardly be meant.
#pragma once

#include <QString>

#include "core/lesson/lesson.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// A line each, the gaps first, of many the first ones; empty: nothing is missing or doubtful.
// `patient`: who is shown, null: none; `shown`: as a lesson names him, empty: he lies nowhere.
QString doubts_in_words(const Lesson& lesson, const PatientCase* patient, const QString& shown);

}  // namespace hepatica
