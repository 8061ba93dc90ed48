// SPDX-License-Identifier: GPL-3.0-or-later
// How a lesson stands, in words with the units that the user chose. Blood alone is said in others:
// mL and mL/min in the clinic, g and g/s else. Files keep what the program computes in.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"
#include "render/chart.h"
#include "ui/flow_units.h"

namespace hepatica {

// As to_words() of core/lesson/predicate.h.
std::string to_words(Quantity quantity, double value, FlowUnits units);
std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names,
                     FlowUnits units);

// Why it was not passed; as in `standing.reasons`.
std::vector<std::string> reasons_in(const LessonStanding& standing,
                                    std::span<const std::string> mark_names, FlowUnits units);

// A chart of bleeding in g/s in these units.
Chart bleeding_in_units(Chart chart, FlowUnits units);

}  // namespace hepatica
