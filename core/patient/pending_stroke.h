// SPDX-License-Identifier: GPL-3.0-or-later
// A brush stroke on the vessels' voxels that waits for a rebuild of the vessels, and its place
// among the corrections. Kept with unsaved work, never in a case.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/image/brush.h"

namespace hepatica {

struct PendingStroke {
    BrushStroke stroke;
    std::size_t after_edits = 0;  // number of corrections when it was drawn
    bool operator==(const PendingStroke&) const = default;
};

// As a JSON array, and back:
//   [{"path_mm": [[1, 2, 3], ...], "radius_mm": 2, "erases": false, "after_edits": 4}]
// Reading throws InputError, naming `place` (the file), where a path is empty or leaves the
// patient's space, or a radius is not above 0 and up to widest_brush_mm.
std::string strokes_to_json(const std::vector<PendingStroke>& strokes);
std::vector<PendingStroke> strokes_from_json(const std::string& text, const std::string& place);

}  // namespace hepatica
