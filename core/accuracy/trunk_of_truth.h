// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the end of a trunk that continues outside the judged region.
#pragma once

#include <optional>

#include "core/accuracy/centreline_samples.h"

namespace hepatica {

// Among the parts of the centrelines that are not judged and lead to nothing judged, the largest by
// volume is taken as the trunk. Returns the sample at which it is attached: where it enters the
// judged region or, if it divides before, its division. Judged stretches under 5 mm are ignored.
// None where the part is shorter than 5 mm.
std::optional<int> end_of_trunk(const CentrelineSamples& line);

}  // namespace hepatica
