// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/metrics.h"

#include <charconv>
#include <nlohmann/json.hpp>

namespace hepatica {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// In the order of display.
constexpr Quantity shown[] = {
    Quantity::time_s,          Quantity::path_mm,          Quantity::peak_force_mn,
    Quantity::impulse_mn_s,    Quantity::contacts,         Quantity::contact_s,
    Quantity::largest_stretch, Quantity::joints_broken,    Quantity::pieces_off,
    Quantity::torn_area_mm2,   Quantity::blood_lost_g,     Quantity::injected_g,
    Quantity::delivered_g,     Quantity::dose_target_g,    Quantity::dose_elsewhere_g,
    Quantity::reflux_g,        Quantity::dose_target_share};

double value_of_mark(Quantity quantity, const MarkMoment& mark) {
    switch (quantity) {
        case Quantity::distance_mm:
            return mark.distance_mm;
        case Quantity::moved_mm:
            return mark.moved_mm;
        default:
            return mark.touch_mm;
    }
}

double value_of(Quantity quantity, const LessonMetrics& m) {
    switch (quantity) {
        case Quantity::time_s:
            return m.time_s;
        case Quantity::path_mm:
            return m.path_mm;
        case Quantity::peak_force_mn:
            return m.peak_force_mn;
        case Quantity::impulse_mn_s:
            return m.impulse_mn_s;
        case Quantity::contacts:
            return m.contacts;
        case Quantity::contact_s:
            return m.contact_s;
        case Quantity::largest_stretch:
            return m.largest_stretch;
        case Quantity::joints_broken:
            return m.joints_broken;
        case Quantity::pieces_off:
            return m.pieces_off;
        case Quantity::torn_area_mm2:
            return m.torn_area_mm2;
        case Quantity::blood_lost_g:
            return m.blood_lost_g;
        case Quantity::injected_g:
            return m.injected_g;
        case Quantity::delivered_g:
            return m.delivered_g;
        case Quantity::dose_target_g:
            return m.dose_target_g;
        case Quantity::dose_elsewhere_g:
            return m.dose_elsewhere_g;
        case Quantity::reflux_g:
            return m.reflux_g;
        case Quantity::dose_target_share:
            return m.delivered_g > 0.0 ? m.dose_target_g / m.delivered_g : nothing;
        default:
            return nothing;
    }
}

double value_of(Quantity quantity, const LessonMoment& moment, double step_time_s) {
    switch (quantity) {
        case Quantity::step_time_s:
            return step_time_s;
        case Quantity::force_mn:
            return moment.force_mn;
        case Quantity::grip_mn:
            return moment.grip_mn;
        case Quantity::stretch:
            return moment.stretch;
        case Quantity::leak_g_s:
            return moment.leak_g_s;
        case Quantity::target_filled:
            return moment.target_filled;
        case Quantity::elsewhere_filled:
            return moment.elsewhere_filled;
        case Quantity::drug_present:
            return moment.drug_present ? 1.0 : 0.0;
        case Quantity::holding:
            return moment.holding ? 1.0 : 0.0;
        default:
            return nothing;
    }
}

}  // namespace

double value_of(const Predicate& predicate, const LessonMetrics& metrics,
                const LessonMoment& moment, double step_time_s) {
    const Quantity quantity = predicate.quantity;
    if (words_of(quantity).of_mark) {
        const auto mark = static_cast<std::size_t>(predicate.mark);  // -1 is beyond the end
        return mark < moment.marks.size() ? value_of_mark(quantity, moment.marks[mark]) : nothing;
    }
    if (quantity < Quantity::step_time_s) return value_of(quantity, metrics);
    return value_of(quantity, moment, step_time_s);
}

nlohmann::ordered_json to_json(const LessonMetrics& metrics) {
    nlohmann::ordered_json json;
    for (const Quantity quantity : shown) {
        const double value = value_of(quantity, metrics);
        const bool whole = quantity == Quantity::contacts || quantity == Quantity::joints_broken ||
                           quantity == Quantity::pieces_off;
        auto& entry = json[words_of(quantity).name];
        if (whole)
            entry = static_cast<int>(value);
        else
            entry = value;  // NaN becomes null
    }
    return json;
}

std::string to_csv(const LessonMetrics& metrics) {
    std::string text = "metric,value,unit\n";
    for (const Quantity quantity : shown) {
        const double value = value_of(quantity, metrics);
        char digits[40];
        const std::string number =
            value == value ? std::string(digits, std::to_chars(digits, digits + 40, value).ptr)
                           : std::string();
        text += std::string(words_of(quantity).name) + "," + number + "," +
                words_of(quantity).unit + "\n";
    }
    return text;
}

}  // namespace hepatica
