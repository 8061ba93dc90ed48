// SPDX-License-Identifier: GPL-3.0-or-later
// Which of a lesson's tools a command takes in hand.
#pragma once

#include <optional>
#include <string>

#include "core/lesson/lesson.h"
#include "core/session/command.h"

namespace hepatica {

// Why a trainee may not give this command in the lesson; empty: he may. Commands that move, turn,
// open or put away what is in hand, hold the clock, and set the solver's accuracy may always be
// given.
std::string objection_to(const Command& command, const Lesson& lesson);

}  // namespace hepatica
