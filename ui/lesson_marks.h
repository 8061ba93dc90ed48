// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of a lesson as the view draws them, in a play or a review.
#pragma once

#include <cstddef>
#include <vector>

#include "core/lesson/lesson.h"
#include "render/mark_actors.h"

namespace hepatica {

// Marks are numbered if there are several, count as reached if no step from `step` on names them or
// all steps are reached, and are wanted if that step names them. `places_mm`: one place for each
// mark of the lesson.
std::vector<MarkView> views_of_marks(const Lesson& lesson, const std::vector<Vec3>& places_mm,
                                     std::size_t step);

}  // namespace hepatica
