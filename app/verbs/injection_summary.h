// SPDX-License-Identifier: GPL-3.0-or-later
// The readable answer of inject: a patient has hundreds of segments, and a line for each would bury
// the rest. --json and --csv contain them all.
#pragma once

#include "app/command_line.h"

namespace hepatica {

// The answer with its lists per segment, outlet and moment replaced by counts, ranges, samples and
// the ten largest flows.
Json summary_of_injection(const Json& answer);

}  // namespace hepatica
