// SPDX-License-Identifier: GPL-3.0-or-later
// What is allowed in a lesson's file and yet can hardly be meant: a tool that the scene has no part
// for, a goal that nothing in the scene can move.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// A sentence each, with what would help; none where nothing is doubtful.
std::vector<std::string> doubts_about(const Lesson& lesson);

}  // namespace hepatica
