// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/predicate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hepatica {

namespace {

using enum Quantity;

constexpr std::array<QuantityWords, 29> table{{
    {time_s, "time_s", "time", "s", false},
    {path_mm, "path_mm", "path of the tip", "mm", false},
    {peak_force_mn, "peak_force_mn", "peak force", "mN", false},
    {impulse_mn_s, "impulse_mn_s", "force over time", "mN s", false},
    {contacts, "contacts", "contacts", "", false},
    {contact_s, "contact_s", "time in contact", "s", false},
    {largest_stretch, "largest_stretch", "largest stretch", "", false},
    {joints_broken, "joints_broken", "joints broken", "", false},
    {pieces_off, "pieces_off", "pieces off", "", false},
    {torn_area_mm2, "torn_area_mm2", "area cut or torn", "mm²", false},
    {blood_lost_g, "blood_lost_g", "blood lost", "g", false},
    {injected_g, "injected_g", "drug injected", "g", false},
    {delivered_g, "delivered_g", "drug delivered", "g", false},
    {dose_target_g, "dose_target_g", "dose in the target", "g", false},
    {dose_elsewhere_g, "dose_elsewhere_g", "dose elsewhere", "g", false},
    {reflux_g, "reflux_g", "reflux of the drug", "g", false},
    {dose_target_share, "dose_target_share", "share of the dose in the target", "", false},
    {step_time_s, "step_time_s", "time of this step", "s", false},
    {force_mn, "force_mn", "force", "mN", false},
    {grip_mn, "grip_mn", "grip", "mN", false},
    {stretch, "stretch", "stretch", "", false},
    {leak_g_s, "leak_g_s", "bleeding", "g/s", false},
    {target_filled, "target_filled", "share of the target that the drug has reached", "", false},
    {elsewhere_filled, "elsewhere_filled", "share of the rest that the drug has reached", "",
     false},
    {drug_present, "drug_present", "injections that are running", "", false},
    {holding, "holding", "vessels held by hand or tool", "", false},
    {distance_mm, "distance_mm", "distance of the tip to", "mm", true},
    {moved_mm, "moved_mm", "way moved by", "mm", true},
    {touch_mm, "touch_mm", "distance of the touch to", "mm", true},
}};

}  // namespace

std::span<const QuantityWords> quantities() {
    return table;
}

const QuantityWords& words_of(Quantity quantity) {
    return table[static_cast<std::size_t>(quantity)];
}

std::string to_words(Quantity quantity, double value, int digits) {
    const QuantityWords& words = words_of(quantity);
    if (!std::isfinite(value)) return "none";
    constexpr double unnoticed = 5e-4;  // in every unit: hides rounding noise of a body at rest
    if (std::abs(value) < unnoticed) value = 0.0;
    char text[64];
    std::snprintf(text, sizeof text, "%.*g%s%s", digits, value, *words.unit ? " " : "", words.unit);
    return text;
}

std::string to_words_beside(const Predicate& predicate, double value) {
    int digits = 4;
    const auto same = [&] {
        return to_words(predicate.quantity, value, digits) ==
               to_words(predicate.quantity, predicate.bound, digits);
    };
    while (digits < 12 && same()) ++digits;
    return to_words(predicate.quantity, value, digits);
}

std::vector<Predicate> add_new(const std::vector<Predicate>& more,
                               std::vector<Predicate>& predicates) {
    const auto before = static_cast<std::ptrdiff_t>(predicates.size());
    for (const Predicate& one : more)
        if (std::ranges::find(predicates, one) == predicates.end()) predicates.push_back(one);
    return {predicates.begin() + before, predicates.end()};
}

std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names) {
    const QuantityWords& words = words_of(predicate.quantity);
    std::string text = words.words;
    const auto mark = static_cast<std::size_t>(predicate.mark);
    if (words.of_mark) text += " " + (mark < mark_names.size() ? mark_names[mark] : "no mark");
    return text + (predicate.at_least ? " at least " : " at most ") +
           to_words(predicate.quantity, predicate.bound);
}

}  // namespace hepatica
