// SPDX-License-Identifier: GPL-3.0-or-later
// A ball of voxels as given on the command line, for remake and edit.
#pragma once

#include <string>

#include "core/image/brush.h"

namespace hepatica {

// Parses X,Y,Z,RADIUS in mm, the radius above 0 and up to 50. Throws UsageError that names the
// option.
BrushStroke dab(const std::string& option, const std::string& text, bool erases);

}  // namespace hepatica
