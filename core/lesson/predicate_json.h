// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds on quantities in the files of lessons, courses and results:
//   [{"what": "moved_mm", "mark": "the mark", "at_least": 10}, {"what": "time_s", "at_most": 60}]
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/lesson/lesson_fields.h"
#include "core/lesson/predicate.h"

namespace hepatica {

// The bounds under this key; empty if it is missing. `marks`: the lesson's mark names. Throws
// InputError as LessonFields does, and for unknown quantities and marks.
std::vector<Predicate> predicates_from(const LessonFields& fields, const char* key,
                                       const std::vector<std::string>& marks);
// A bound whose mark is none of `marks` is written without one, which predicates_from() takes of
// unfinished lessons alone.
nlohmann::ordered_json json_of(const std::vector<Predicate>& bounds,
                               const std::vector<std::string>& marks);

}  // namespace hepatica
