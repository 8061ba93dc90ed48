// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds on the quantities of a play. A goal is a list of bounds that must hold simultaneously, a
// limit must always hold, a pass mark at the end. All lessons consist of these; none has code of
// its own.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace hepatica {

// Measured quantities: up to dose_target_share accumulated since the lesson began, then of the
// present moment, from distance_mm on of the moment and a mark. Order and names are part of the
// file formats.
enum class Quantity {
    time_s,
    path_mm,
    peak_force_mn,
    impulse_mn_s,
    contacts,
    contact_s,
    largest_stretch,
    joints_broken,
    pieces_off,
    torn_area_mm2,
    blood_lost_g,
    injected_g,
    delivered_g,
    dose_target_g,
    dose_elsewhere_g,
    reflux_g,
    dose_target_share,
    step_time_s,
    force_mn,
    grip_mn,
    stretch,
    leak_g_s,
    target_filled,
    elsewhere_filled,
    drug_present,
    holding,
    distance_mm,
    moved_mm,
    touch_mm,
};

struct QuantityWords {
    Quantity quantity;
    const char* name;   // in files
    const char* words;  // shown to the user, without unit
    const char* unit;   // empty: none
    bool of_mark;
};

// In the order of the enumeration.
std::span<const QuantityWords> quantities();
const QuantityWords& words_of(Quantity quantity);

// Bound: a quantity is at least, or at most, a number.
struct Predicate {
    Quantity quantity = Quantity::time_s;
    int mark = -1;  // index of the lesson's mark, for quantities of a mark; -1: none
    bool at_least = true;
    double bound = 0.0;

    // NaN (unknown) never holds. Times are sums of steps: their rounding breaks no bound.
    bool holds(double value) const {
        const bool is_time = quantity == Quantity::time_s || quantity == Quantity::step_time_s;
        const double rounding = is_time ? 1e-9 : 0.0;
        return at_least ? value >= bound - rounding : value <= bound + rounding;
    }
    // The worse of two values, for a limit.
    double worse(double a, double b) const { return (a < b) == at_least ? a : b; }
    bool operator==(const Predicate&) const = default;
};

// Appends those that `predicates` does not contain yet. Returns the ones that were appended.
std::vector<Predicate> add_new(const std::vector<Predicate>& more,
                               std::vector<Predicate>& predicates);

// "force at most 600 mN", "distance of the tip to the first mark at most 5 mm"; of a bound whose
// mark is gone (-1) "... to no mark ...".
std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names);
// "12.5 mN"; "none" if not finite.
std::string to_words(Quantity quantity, double value, int digits = 4);
// With as many digits as needed to differ from the bound that it broke (4 to 12).
std::string to_words_beside(const Predicate& predicate, double value);

}  // namespace hepatica
