// SPDX-License-Identifier: GPL-3.0-or-later
// What a lesson asks of a play, as bounds on quantities: a goal is a list of them that hold at
// once, a limit one that always holds, a pass mark one that holds at the end. Every lesson is made
// of these; none has code of its own.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace hepatica {

// What can be asked for. The first ones have grown since the lesson began, the middle ones are of
// the moment, the last ones of the moment and of a mark.
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
    const char* words;  // for a person, without the unit
    const char* unit;   // may be empty
    bool of_mark;
};

// All of them, in the order of the enumeration.
std::span<const QuantityWords> quantities();
const QuantityWords& words_of(Quantity quantity);

// A quantity is at least, or at most, a number.
struct Predicate {
    Quantity quantity = Quantity::time_s;
    int mark = -1;  // index into the lesson's marks, of quantities that have one
    bool at_least = true;
    double bound = 0.0;

    // NaN, which an unknown quantity is, keeps no bound.
    bool holds(double value) const { return at_least ? value >= bound : value <= bound; }
    // The worse of two values, for a limit.
    double worse(double a, double b) const { return (a < b) == at_least ? a : b; }
    bool operator==(const Predicate&) const = default;
};

// Appends those that are not among them yet.
void add_new(const std::vector<Predicate>& more, std::vector<Predicate>& predicates);

// "force at most 600 mN", "distance of the tip to the first mark at most 5 mm"; of a bound whose
// mark is gone (-1) "... to no mark ...".
std::string to_words(const Predicate& predicate, std::span<const std::string> mark_names);
// "12.5 mN".
std::string to_words(Quantity quantity, double value, int digits = 4);
// With as many digits as it takes to be told apart from the bound that it broke.
std::string to_words_beside(const Predicate& predicate, double value);

}  // namespace hepatica
