// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices of a torn body are drawn as the rims of its tears.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tear/tearing.h"

namespace hepatica {

// Per vertex: 1 for each that has come apart from another one that it was split from or with, and
// is no longer tied to it. Until a joint has come apart completely, only for the edges of joints
// that have parted at both ends, as of a cut that goes part of the way: a single corner that came
// apart is no rim yet, because the body does not count as torn.
std::vector<std::uint8_t> torn_rims(const Tearing& tearing);

}  // namespace hepatica
