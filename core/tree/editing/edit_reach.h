// SPDX-License-Identifier: GPL-3.0-or-later
// How far an edit reaches for the vessel that it names by a place.
#pragma once

namespace hepatica {

// Farther from a vessel, an edit is refused. A rebuilding moves vessels a little.
constexpr double edit_reach_mm = 10.0;

}  // namespace hepatica
