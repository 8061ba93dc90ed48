// SPDX-License-Identifier: GPL-3.0-or-later
// How a lesson stands, in words with the units that the user chose. Blood alone is said in others:
// mL and mL/min in the clinic, g and g/s else. Files keep what the program computes in.
#pragma once

#include <QString>
#include <span>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"
#include "render/chart.h"
#include "ui/flow_units.h"

namespace hepatica {

// What was measured, with three digits that mean something at most: "24.1 s", "467 mN".
std::string to_words(Quantity quantity, double value, FlowUnits units);
// The same, with as many digits as it takes to be told apart from the bound.
std::string to_words_beside(const Predicate& bound, double value, FlowUnits units);
// As to_words() of core/lesson/predicate.h, but "no pieces torn off" where none is allowed.
std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names,
                     FlowUnits units);

// Why it was not passed; as in `standing.reasons`.
std::vector<std::string> reasons_in(const LessonStanding& standing,
                                    std::span<const std::string> mark_names, FlowUnits units);

// A line breaks before no unit: a narrow space that holds stands between it and its number.
QString with_units_beside(QString text);

// A chart of bleeding in g/s in these units.
Chart bleeding_in_units(Chart chart, FlowUnits units);

}  // namespace hepatica
