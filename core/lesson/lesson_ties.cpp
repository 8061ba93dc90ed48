// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_ties.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <variant>

#include "core/lesson/target_region.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

// A place has not moved if it is off by at most this or the radius: rebuilt centrelines differ
// slightly.
constexpr double same_place_mm = 1.0;
// Tolerated change of the length beyond a target.
constexpr double same_length_mm = 2.0, same_length_share = 0.01;

// One place of a lesson, and its tie in the lesson.
struct TiedPlace {
    using OnTree = std::function<TreePoint(const VesselTree&)>;
    std::string name;
    OnTree on_tree;
    std::optional<PlaceTie>* tie;
    bool has_beyond = false;
};

TreePoint on_tree(const ScriptPlace& place, const VesselTree& tree) {
    return nearest_point(tree, position_of(place, tree));
}

// The sample on the blade nearest to a centreline.
TreePoint on_tree(const Blade& blade, const VesselTree& tree) {
    constexpr int samples = 32;
    TreePoint nearest;
    for (int i = 0; i <= samples; ++i) {
        const Vec3 at = blade.from_mm + (blade.to_mm - blade.from_mm) * i / samples;
        const TreePoint point = nearest_point(tree, at);
        if (nearest.segment < 0 || point.distance_mm < nearest.distance_mm) nearest = point;
    }
    return nearest;
}

bool same(const SetupPlace& a, const SetupPlace& b) {
    if (a.index() != b.index()) return false;
    if (const auto* blade = std::get_if<Blade>(&a)) {
        const auto& other = std::get<Blade>(b);
        return blade->from_mm == other.from_mm && blade->to_mm == other.to_mm;
    }
    const auto &place = std::get<ScriptPlace>(a), &other = std::get<ScriptPlace>(b);
    return place.point_mm == other.point_mm &&
           place.share_of_longest_path == other.share_of_longest_path;
}

bool names_a_place(const ScriptPlace& place) {
    return place.point_mm || place.share_of_longest_path;
}

// Where a command of a recording acts; an action of its own kind names its place beside it.
std::optional<SetupPlace> place_of(const Command& command) {
    if (const auto* blade = std::get_if<Blade>(&command)) return *blade;
    return std::visit(
        [](const auto& one) -> std::optional<SetupPlace> {
            if constexpr (requires { Vec3(one.point_mm); })
                return ScriptPlace{Vec3(one.point_mm), std::nullopt};
            else
                return std::nullopt;
        },
        command);
}

// The places of a setup's actions, in order.
std::vector<SetupPlace> places_of(const Script& setup) {
    std::vector<SetupPlace> places;
    for (const ScriptAction& action : setup.actions) {
        for (const ScriptPlace& place : {action.place, action.to_place})
            if (names_a_place(place)) places.emplace_back(place);
        if (!action.command || names_a_place(action.place)) continue;
        if (const auto place = place_of(*action.command)) places.push_back(*place);
    }
    return places;
}

// One entry per place of the setup, with the tie that was stored for that place.
std::vector<SetupTie> in_order_of_setup(const Lesson& lesson) {
    std::vector<SetupTie> ties;
    for (const SetupPlace& place : places_of(lesson.setup)) {
        const auto noted = std::ranges::find_if(
            lesson.setup_ties, [&](const SetupTie& tie) { return same(tie.of, place); });
        ties.push_back({place, noted == lesson.setup_ties.end() ? std::nullopt : noted->tie});
    }
    return ties;
}

// All places of the lesson, with pointers to their ties.
std::vector<TiedPlace> places_of(Lesson& lesson) {
    std::vector<TiedPlace> places;
    const auto at = [](const auto& place) {
        return [place](const VesselTree& tree) { return on_tree(place, tree); };
    };
    for (LessonMark& mark : lesson.marks)
        places.push_back({"\"" + mark.name + "\"", at(mark.place), &mark.tie});
    if (lesson.target)
        places.push_back({"The target", at(*lesson.target), &lesson.target_tie, true});
    lesson.setup_ties = in_order_of_setup(lesson);
    for (std::size_t i = 0; i < lesson.setup_ties.size(); ++i) {
        auto& [of, tie] = lesson.setup_ties[i];
        places.push_back(
            {"Place " + std::to_string(i + 1) + " of the setup",
             std::visit([&at](const auto& place) -> TiedPlace::OnTree { return at(place); }, of),
             &tie});
    }
    return places;
}

Station station_of(const TreePoint& point, const VesselTree& tree) {
    return station_at(tree.segments[static_cast<std::size_t>(point.segment)], point.arclength_mm);
}

// Total length of the vessels beyond the place, including the rest of its own segment.
double beyond_mm(const TreePoint& from, const VesselTree& tree) {
    const TargetRegion region(tree, from);
    double sum = -from.arclength_mm;
    for (std::size_t s = 0; s < tree.segments.size(); ++s)
        if (region.contains_end_of(static_cast<int>(s))) sum += length_mm(tree.segments[s]);
    return sum;
}

double to_a_tenth(double mm) {
    return std::round(10.0 * mm) / 10.0;
}

PlaceTie tie_of(const TiedPlace& place, const VesselTree& tree) {
    const TreePoint at = place.on_tree(tree);
    const Station station = station_of(at, tree);
    PlaceTie tie{(10.0 * station.position_mm).array().round() / 10.0, to_a_tenth(station.radius_mm),
                 0.0};
    if (place.has_beyond) tie.beyond_mm = to_a_tenth(beyond_mm(at, tree));
    return tie;
}

std::string in_mm(double mm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f mm", mm);
    return text;
}

// Empty: the place has not moved.
std::string misfit_of(const TiedPlace& place, const VesselTree& tree) {
    const PlaceTie &then = **place.tie, now = tie_of(place, tree);
    const double moved_mm = (now.at_mm - then.at_mm).norm();
    if (moved_mm > std::max(same_place_mm, then.radius_mm))
        return place.name + " now lies " + in_mm(moved_mm) +
               " from where it was when the lesson was made.";
    if (std::abs(now.beyond_mm - then.beyond_mm) >
        std::max(same_length_mm, same_length_share * then.beyond_mm))
        return place.name + " has " + in_mm(now.beyond_mm) + " of vessels beyond it, and had " +
               in_mm(then.beyond_mm) + " when the lesson was made.";
    return "";
}

}  // namespace

bool can_be_tied(const Lesson& lesson) {
    return lesson.patient != "any" && lesson.patient != "built-in";
}

bool is_tied(const Lesson& lesson) {
    Lesson copy = lesson;  // its places have room for ties
    return std::ranges::all_of(places_of(copy),
                               [](const TiedPlace& place) { return place.tie->has_value(); });
}

void tie(Lesson& lesson, const VesselTree& tree) {
    if (!can_be_tied(lesson)) return;
    for (TiedPlace& place : places_of(lesson))
        if (!*place.tie) *place.tie = tie_of(place, tree);
}

void untie(Lesson& lesson) {
    for (LessonMark& mark : lesson.marks) mark.tie.reset();
    lesson.target_tie.reset();
    lesson.setup_ties.clear();
}

std::vector<std::string> misfits(const Lesson& lesson, const VesselTree& tree) {
    std::vector<std::string> found;
    if (!can_be_tied(lesson)) return found;
    Lesson copy = lesson;
    for (const TiedPlace& place : places_of(copy))
        if (*place.tie)
            if (std::string misfit = misfit_of(place, tree); !misfit.empty())
                found.push_back(std::move(misfit));
    return found;
}

}  // namespace hepatica
