// SPDX-License-Identifier: GPL-3.0-or-later
// Where the trunk of a system ends that goes on beyond what is judged.
#pragma once

#include <optional>

#include "core/accuracy/centreline_samples.h"

namespace hepatica {

// The sample at which the largest part by volume of what neither is judged nor leads to anything
// that is hangs on the rest: where the trunk enters what is judged or, where it divides before, its
// division. Judged ways of under 5 mm count as none. None where under 5 mm hang there.
std::optional<int> end_of_trunk(const CentrelineSamples& line);

}  // namespace hepatica
