// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_words.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "core/base/units.h"
#include "core/flow/fluid.h"

namespace hepatica {
namespace {

// What the clinic says in another unit.
bool is_of_blood(Quantity quantity) {
    return quantity == Quantity::leak_g_s || quantity == Quantity::blood_lost_g;
}

double in_clinic_units(Quantity quantity, double value) {
    const double density_g_mm3 = blood().density_g_mm3;
    return quantity == Quantity::leak_g_s ? ml_min_of(value, density_g_mm3)
                                          : value / density_g_mm3 / units::millilitre;
}

std::string blood_words(Quantity quantity, double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g %s", digits, in_clinic_units(quantity, value),
                  quantity == Quantity::leak_g_s ? "mL/min" : "mL");
    return text;
}

constexpr int usual_digits = 4;

// With as many digits as it takes to be told apart from the bound.
std::string words_beside(const Predicate& bound, double value) {
    int digits = usual_digits;
    while (digits < 12 && blood_words(bound.quantity, value, digits) ==
                              blood_words(bound.quantity, bound.bound, digits))
        ++digits;
    return blood_words(bound.quantity, value, digits);
}

}  // namespace

std::string to_words(Quantity quantity, double value, FlowUnits units) {
    if (units == FlowUnits::computed || !is_of_blood(quantity)) return to_words(quantity, value);
    return blood_words(quantity, value, usual_digits);
}

std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names,
                     FlowUnits units) {
    if (units == FlowUnits::computed || !is_of_blood(predicate.quantity))
        return to_words(predicate, mark_names);
    return words_of(predicate.quantity).words +
           std::string(predicate.at_least ? " at least " : " at most ") +
           blood_words(predicate.quantity, predicate.bound, usual_digits);
}

std::vector<std::string> reasons_in(const LessonStanding& standing,
                                    std::span<const std::string> mark_names, FlowUnits units) {
    std::vector<std::string> reasons = standing.reasons;
    if (units == FlowUnits::computed) return reasons;
    const auto say = [&](const BoundStanding& bound, const std::string& as_computed,
                         const std::string& before, const std::string& value) {
        if (bound.kept || !is_of_blood(bound.predicate.quantity)) return;
        std::ranges::replace(reasons, as_computed,
                             before + to_words(bound.predicate, mark_names, units) + value);
    };
    for (const BoundStanding& limit : standing.limits)
        say(limit, reason_of_limit(limit, mark_names),
            "limit broken: ", ", but it was " + words_beside(limit.predicate, limit.value));
    for (const BoundStanding& mark : standing.pass)
        say(mark, reason_of_pass_mark(mark, mark_names), "pass mark missed: ",
            ", but it is " + to_words(mark.predicate.quantity, mark.value, units));
    return reasons;
}

Chart bleeding_in_units(Chart chart, FlowUnits units) {
    constexpr std::string_view grams = "(g/s)";
    const std::size_t at = chart.y_label.find(grams);
    if (units == FlowUnits::computed || at == std::string::npos) return chart;
    chart.y_label.replace(at, grams.size(), "(mL/min)");
    for (Curve& curve : chart.curves)
        for (double& flow : curve.y) flow = in_clinic_units(Quantity::leak_g_s, flow);
    return chart;
}

}  // namespace hepatica
