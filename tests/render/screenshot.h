// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a picture with tests/render/baselines/NAME.png. A failing test leaves the new picture in
// the build folder; HEPATICA_UPDATE_BASELINES=1 replaces the baseline (look at it before you
// commit).
#pragma once

#include <string>

#include "render/picture.h"

namespace hepatica::testing {

void expect_matches_baseline(const Picture& picture, const std::string& name);

}  // namespace hepatica::testing
