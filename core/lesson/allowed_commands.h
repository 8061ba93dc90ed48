// SPDX-License-Identifier: GPL-3.0-or-later
// Which commands a trainee may give in a lesson.
#pragma once

#include <string>

#include "core/lesson/lesson.h"
#include "core/session/command.h"

namespace hepatica {

// Returns why a trainee may not give this command in the lesson; empty: allowed. Commands that take
// a tool, pull, cut, inject or change settings need the lesson's permission. ResetWorld and
// RestoreSnapshot are never allowed. All others always are; they move, turn, open or release what
// is held, pause, control a running injection, or set the solver's accuracy.
std::string objection_to(const Command& command, const Lesson& lesson);

}  // namespace hepatica
