// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_words.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "core/base/three_digits.h"
#include "core/base/units.h"
#include "core/flow/fluid.h"
#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Quantities that have other units in the clinic.
bool is_of_blood(Quantity quantity) {
    return quantity == Quantity::leak_g_s || quantity == Quantity::blood_lost_g;
}

double in_clinic_units(Quantity quantity, double value) {
    const double density_g_mm3 = blood().density_g_mm3;
    return quantity == Quantity::leak_g_s ? ml_min_of(value, density_g_mm3)
                                          : value / density_g_mm3 / units::millilitre;
}

// The unit with the space before it.
std::string beside_value(const ShownValue& shown) {
    return shown.unit.empty() ? "" : " " + shown.unit;
}

// Decimals of a measured value, limited to the meaningful ones and constant, so that a running
// number keeps its width.
int decimals_of(Quantity quantity, FlowUnits units) {
    switch (quantity) {
        case Quantity::largest_stretch:
        case Quantity::stretch:
        case Quantity::dose_target_share:
        case Quantity::target_filled:
        case Quantity::elsewhere_filled:
            return 2;
        case Quantity::leak_g_s:
            return units == FlowUnits::clinic ? 0 : 2;
        case Quantity::blood_lost_g:
            return 1;
        case Quantity::injected_g:
        case Quantity::delivered_g:
        case Quantity::dose_target_g:
        case Quantity::dose_elsewhere_g:
        case Quantity::reflux_g:
            return 2;
        case Quantity::time_s:
        case Quantity::step_time_s:
        case Quantity::contact_s:
        case Quantity::path_mm:
        case Quantity::torn_area_mm2:
        case Quantity::distance_mm:
        case Quantity::moved_mm:
        case Quantity::touch_mm:
            return 1;
        default:  // forces in mN, and counts
            return 0;
    }
}

bool is_dose(const Predicate& bound) {
    return bound.quantity == Quantity::delivered_g || bound.quantity == Quantity::dose_target_g ||
           bound.quantity == Quantity::dose_elsewhere_g || bound.quantity == Quantity::reflux_g ||
           bound.quantity == Quantity::dose_target_share;
}

// Whether a bound of the lesson, or one that a course adds to it, is on a dose.
bool judges_doses(const LessonStanding& standing, const Lesson& lesson) {
    const auto is_of_dose = [](const BoundStanding& bound) { return is_dose(bound.predicate); };
    return std::ranges::any_of(standing.pass, is_of_dose) ||
           std::ranges::any_of(standing.limits, is_of_dose) ||
           std::ranges::any_of(lesson.steps, [](const LessonStep& step) {
               return std::ranges::any_of(step.goal, is_dose);
           });
}

template <class Number>
std::string printed(const char* format, int digits, Number value) {
    char text[64];
    std::snprintf(text, sizeof text, format, digits, value);
    return text;
}

// No narrow one: Qt's rich text makes a common space of it.
constexpr QChar no_break_space(0xa0);
constexpr int most_digits = 3;  // significant digits of a measured value

std::string number_words(double value, int decimals) {
    value = in_three_digits(value);
    int before_point =
        value == 0.0 ? 1
                     : std::max(1, 1 + static_cast<int>(std::floor(std::log10(std::abs(value)))));
    const double rounded = std::round(value / std::pow(10.0, before_point - most_digits));
    // 99.96 has three digits before the point once it is rounded.
    if (std::abs(rounded) >= std::pow(10.0, most_digits)) ++before_point;
    const std::string text =
        printed("%.*f", std::clamp(most_digits - before_point, 0, decimals), value);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-'
               ? text.substr(1)
               : text;
}

// A bound keeps the digits of its author, up to four. In other units than his it has no more than
// what is measured.
std::string bound_words(const Predicate& predicate, FlowUnits units) {
    const ShownValue bound = shown_value(predicate.quantity, predicate.bound, units);
    if (bound.value == predicate.bound)
        return printed("%.*g", 4, bound.value) + beside_value(bound);
    // To the side on which it is kept: what breaks it must not seem to keep it.
    constexpr double rounding = 1e-9;
    const double finest =
        std::pow(10.0, std::floor(std::log10(std::abs(bound.value))) + 1.0 - most_digits);
    const double count = bound.value / finest;
    const double kept =
        finest * (predicate.at_least ? std::ceil(count - rounding) : std::floor(count + rounding));
    return printed("%.*g", 12, kept) + beside_value(bound);
}

}  // namespace

ShownValue shown_value(Quantity quantity, double value, FlowUnits units) {
    if (units == FlowUnits::clinic && is_of_blood(quantity))
        return {in_clinic_units(quantity, value), quantity == Quantity::leak_g_s ? "mL/min" : "mL"};
    return {value, words_of(quantity).unit};
}

std::string to_words(Quantity quantity, double value, FlowUnits units) {
    if (!std::isfinite(value)) return "none";
    const ShownValue number = shown_value(quantity, value, units);
    return number_words(number.value, decimals_of(quantity, units)) + beside_value(number);
}

bool is_count(Quantity quantity) {
    return quantity == Quantity::contacts || quantity == Quantity::joints_broken ||
           quantity == Quantity::pieces_off || quantity == Quantity::drug_present ||
           quantity == Quantity::holding;
}

bool allows_none(const Predicate& predicate) {
    return is_count(predicate.quantity) && !predicate.at_least && predicate.bound == 0.0;
}

std::string to_words_beside(const Predicate& predicate, double value, FlowUnits units) {
    const ShownValue broke = shown_value(predicate.quantity, value, units);
    const double bound = shown_value(predicate.quantity, predicate.bound, units).value;
    const int decimals = decimals_of(predicate.quantity, units);
    if (!std::isfinite(value) ||
        number_words(broke.value, decimals) != number_words(bound, decimals))
        return to_words(predicate.quantity, value, units);
    int digits = most_digits;
    while (digits < 12 && printed("%.*g", digits, broke.value) == printed("%.*g", digits, bound))
        ++digits;
    return printed("%.*g", digits, broke.value) + beside_value(broke);
}

std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names,
                     FlowUnits units) {
    const QuantityWords& words = words_of(predicate.quantity);
    if (allows_none(predicate)) return std::string("no ") + words.words;
    if (words.of_mark) return to_words(predicate, mark_names);
    return words.words + std::string(predicate.at_least ? " at least " : " at most ") +
           bound_words(predicate, units);
}

std::vector<std::string> reasons_in(const LessonStanding& standing,
                                    std::span<const std::string> mark_names, FlowUnits units) {
    std::vector<std::string> reasons = standing.reasons;
    const auto say = [&](const BoundStanding& bound, const std::string& as_computed,
                         const std::string& before, const std::string& value) {
        if (bound.kept) return;
        std::ranges::replace(reasons, as_computed,
                             before + to_words(bound.predicate, mark_names, units) + value);
    };
    for (const BoundStanding& limit : standing.limits)
        say(limit, reason_of_limit(limit, mark_names), "limit broken: ",
            ", but it was " + to_words_beside(limit.predicate, limit.value, units));
    for (const BoundStanding& mark : standing.pass)
        say(mark, reason_of_pass_mark(mark, mark_names), "pass mark missed: ",
            ", but it is " + to_words_beside(mark.predicate, mark.value, units));
    return reasons;
}

QString drug_on_its_way(const LessonStanding& standing, const Lesson& lesson, FlowUnits units) {
    constexpr double least_g = 0.01;  // two decimals are shown
    const double on_its_way_g = standing.metrics.injected_g - standing.metrics.delivered_g;
    if (!(on_its_way_g >= least_g) || !judges_doses(standing, lesson)) return {};
    const auto said = [&](double dose_g) {
        return translated(to_words(Quantity::injected_g, dose_g, units));
    };
    return Words::tr(
               "Doses are judged by the %1 of %2 that had come out of the ends of the vessels by "
               "then: the other %3 of the drug count neither in the target nor elsewhere, wherever "
               "they would have gone.")
        .arg(said(standing.metrics.delivered_g), said(standing.metrics.injected_g),
             said(on_its_way_g));
}

QString with_units_beside(QString text) {
    static const QRegularExpression unit(
        R"((?<=\d) (?=(?:mN s|mN|mm²|mm|mL/min|mL|g/s|g|s)(?!\w)))"),
        within("mN s(?!\\w)");
    return text.replace(unit, no_break_space).replace(within, "mN" + QString(no_break_space) + "s");
}

// The last step may be reached in the moment of the verdict, and its label stands above that.
std::vector<PlotEvent> plot_events_of(const LessonStanding& standing) {
    std::vector<PlotEvent> events;
    for (std::size_t i = 0; i < standing.steps.size(); ++i)
        if (standing.steps[i].reached_s)
            events.push_back({*standing.steps[i].reached_s, Words::tr("step %1").arg(i + 1)});
    if (standing.outcome == LessonOutcome::failed && !standing.reasons.empty())
        events.push_back({standing.metrics.time_s, Words::tr("verdict: not passed")});
    return events;
}

Chart bleeding_in_units(Chart chart, FlowUnits units) {
    constexpr std::string_view grams = "(g/s)";
    if (units == FlowUnits::computed || !chart.y_label.ends_with(grams)) return chart;
    chart.y_label = Words::id("Bleeding (mL/min)");
    for (Curve& curve : chart.curves)
        for (double& flow : curve.y) flow = in_clinic_units(Quantity::leak_g_s, flow);
    return chart;
}

}  // namespace hepatica
