// SPDX-License-Identifier: GPL-3.0-or-later
// Rewrites advice for users of the window: core names remedies by command line options, which are
// replaced here by the field or tool that does the same.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

// The text with each such option replaced; other text is unchanged.
std::string in_window_words(std::string text);

// The first two warnings, translated, and the number of others; short, to leave room for the
// vessels.
QString in_short(const std::vector<std::string>& warnings);

// Whether the problem already contains its place, a file path, which then need not be repeated.
bool names_its_place(const Failure& failure);

// The place of a failure as the user knows it; a position in the patient as
// patient_place_in_words() says it.
QString place_in_words(const Failure& failure);

// Problem and remedy as one sentence in the language of the window.
QString in_one_sentence(const Failure& failure);

}  // namespace hepatica
