// SPDX-License-Identifier: GPL-3.0-or-later
// Advice for somebody who sits before the window. Core names a remedy by the option of the command
// line that gives it; here every option becomes the field or the tool that does the same.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

// The text with each such option replaced; any other text stays as it is.
std::string in_window_words(std::string text);

// The first two of several warnings in the language of the window, and how many more there are:
// what leaves room for the vessels.
QString in_short(const std::vector<std::string>& warnings);

// What is wrong and what helps, as a sentence that stands by itself, in the language of the window.
// Whether the problem names the file that is its place: then it is not named once more.
bool names_its_place(const Failure& failure);

QString in_one_sentence(const Failure& failure);

}  // namespace hepatica
