// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds on quantities as files of lessons, courses and results have them:
//   [{"what": "moved_mm", "mark": "the mark", "at_least": 10}, {"what": "time_s", "at_most": 60}]
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/lesson/lesson_fields.h"
#include "core/lesson/predicate.h"

namespace hepatica {

// Those under this key; none where it is not there. Throws InputError as LessonFields does, and for
// a quantity that is not measured or a mark that is none of these.
std::vector<Predicate> predicates_from(const LessonFields& fields, const char* key,
                                       const std::vector<std::string>& marks);
nlohmann::ordered_json json_of(const std::vector<Predicate>& bounds,
                               const std::vector<std::string>& marks);

}  // namespace hepatica
