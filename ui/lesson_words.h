// SPDX-License-Identifier: GPL-3.0-or-later
// The standing of a lesson in words, in the user's units: blood in mL and mL/min (clinic) or g and
// g/s. Files keep the units of the computation.
#pragma once

#include <QString>
#include <span>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"
#include "render/chart.h"
#include "ui/flow_units.h"
#include "ui/plot_panel.h"

namespace hepatica {

// A value in these units, and its unit, which may be empty.
struct ShownValue {
    double value = 0.0;
    std::string unit;
};
ShownValue shown_value(Quantity quantity, double value, FlowUnits units);

// A measured value with at most three significant digits: "24.1 s", "467 mN".
std::string to_words(Quantity quantity, double value, FlowUnits units);
// The same with as many digits as needed to differ from the bound.
std::string to_words_beside(const Predicate& bound, double value, FlowUnits units);
// Whether it is counted, in whole numbers.
bool is_count(Quantity quantity);
// Whether a count must stay at none.
bool allows_none(const Predicate& predicate);
// As to_words() of core/lesson/predicate.h, but "no pieces off" if none is allowed.
std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names,
                     FlowUnits units);

// Why the lesson was not passed; as `standing.reasons`, but in these units.
std::vector<std::string> reasons_in(const LessonStanding& standing,
                                    std::span<const std::string> mark_names, FlowUnits units);

// Of a lesson that judges doses: how much of the drug had not come out of the vessels when it
// ended, which counts as no dose. Empty where the lesson judges none, or all of it had come out.
QString drug_on_its_way(const LessonStanding& standing, const Lesson& lesson, FlowUnits units);

// For plots over time: when the steps were reached, and when the attempt failed.
std::vector<PlotEvent> plot_events_of(const LessonStanding& standing);

// Puts a no-break space between a number and its unit.
QString with_units_beside(QString text);

// Converts a chart of bleeding in g/s to these units; returns any other unchanged.
Chart bleeding_in_units(Chart chart, FlowUnits units);

}  // namespace hepatica
