// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson's marks as the view draws them, in a play and in a review of one.
#pragma once

#include <cstddef>
#include <vector>

#include "core/lesson/lesson.h"
#include "render/mark_actors.h"

namespace hepatica {

// Numbered where there are more than one, and reached where no step from the present one on names
// them any more. `places_mm`: one for each of the lesson's marks.
std::vector<MarkView> views_of_marks(const Lesson& lesson, const std::vector<Vec3>& places_mm,
                                     std::size_t step);

}  // namespace hepatica
