// SPDX-License-Identifier: GPL-3.0-or-later
// What inject prints to be read: a patient has hundreds of segments, and a line for each buries the
// rest. --json and --csv hold them all.
#pragma once

#include "app/command_line.h"

namespace hepatica {

// The answer with its lists per segment, outlet and moment replaced by counts, ranges and the ten
// largest flows.
Json summary_of_injection(const Json& answer);

}  // namespace hepatica
