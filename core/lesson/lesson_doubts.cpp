// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_doubts.h"

#include <algorithm>
#include <cstdio>

#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_reach.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

enum class Part { moving, touching, tearing, flowing };

bool has(const SceneSpec& scene, Part part) {
    switch (part) {
        case Part::moving:
            return scene.deform.has_value();
        case Part::touching:
            return scene.contact && scene.contact->tools;
        case Part::tearing:
            return scene.tear.has_value();
        case Part::flowing:
            return scene.flow.has_value();
    }
    return false;
}

std::string name_of(Part part) {
    switch (part) {
        case Part::moving:
            return "vessels that move";
        case Part::touching:
            return "tools that touch the vessels";
        case Part::tearing:
            return "vessels that tear";
        case Part::flowing:
            return "a drug that flows";
    }
    return "";
}

// The part that a tool needs to have an effect; settings need none.
std::optional<Part> part_of(LessonTool tool) {
    switch (tool) {
        case LessonTool::pull:
            return Part::moving;
        case LessonTool::sphere:
        case LessonTool::capsule:
        case LessonTool::forceps:
        case LessonTool::hook:
            return Part::touching;
        case LessonTool::blade:
        case LessonTool::cut_line:
            return Part::tearing;
        case LessonTool::inject:
            return Part::flowing;
        case LessonTool::settings:
            return std::nullopt;
    }
    return std::nullopt;
}

// The part that a quantity needs to change from its initial value. Paths and distances of a tool's
// tip need none.
std::optional<Part> part_of(Quantity quantity) {
    using enum Quantity;
    switch (quantity) {
        case peak_force_mn:
        case impulse_mn_s:
        case largest_stretch:
        case force_mn:
        case stretch:
        case holding:
        case moved_mm:
            return Part::moving;
        case contacts:
        case contact_s:
        case grip_mn:
        case touch_mm:
            return Part::touching;
        case joints_broken:
        case pieces_off:
        case torn_area_mm2:
        case blood_lost_g:
        case leak_g_s:
            return Part::tearing;
        case injected_g:
        case delivered_g:
        case dose_target_g:
        case dose_elsewhere_g:
        case reflux_g:
        case dose_target_share:
        case target_filled:
        case elsewhere_filled:
        case drug_present:
            return Part::flowing;
        default:
            return std::nullopt;
    }
}

bool asks_for_target(Quantity quantity) {
    using enum Quantity;
    return quantity == dose_target_g || quantity == dose_elsewhere_g ||
           quantity == dose_target_share || quantity == target_filled ||
           quantity == elsewhere_filled;
}

struct NamedPoint {
    std::string name;
    Vec3 at_mm;
};

// The marks and the target given as points, not as shares of the longest path.
std::vector<NamedPoint> points_of(const Lesson& lesson) {
    std::vector<NamedPoint> points;
    for (const LessonMark& mark : lesson.marks)
        if (mark.place.point_mm) points.push_back({"\"" + mark.name + "\"", *mark.place.point_mm});
    if (lesson.target && lesson.target->point_mm)
        points.push_back({"The target", *lesson.target->point_mm});
    return points;
}

class Doubter {
  public:
    Doubter(const Lesson& lesson, const std::filesystem::path& folder)
        : lesson_(lesson), folder_(folder), marks_(lesson.mark_names()) {}

    std::vector<std::string> all() {
        look_at_patient();
        look_at_tools();
        look_at_places();
        for (std::size_t i = 0; i < lesson_.steps.size(); ++i) look_at_step(i);
        const double all_s = least_time_s(lesson_, lesson_.steps.size());
        for (const Predicate& bound : lesson_.limits) {
            look_at(bound, "Limits all the time");
            look_at_limit(bound, "Limits all the time", true);
            look_at_time(bound, "Limits all the time", all_s, longest_step_s());
        }
        for (const Predicate& bound : lesson_.pass) {
            look_at(bound, "Pass marks");
            look_at_time(bound, "Pass marks", all_s, 0.0);
        }
        return std::move(doubts_);
    }

  private:
    void look_at_patient() {
        if (lesson_.patient == "any" || lesson_.patient == "built-in") return;
        std::error_code unknown;
        if (!std::filesystem::exists(folder_ / lesson_.patient, unknown))
            doubts_.push_back("The case " + (folder_ / lesson_.patient).string() +
                              " is not there: choose the patient again.");
    }

    void look_at_tools() {
        if (lesson_.tools.empty())
            doubts_.push_back("The trainee may use no tool: allow one at least.");
        for (const LessonTool tool : lesson_.tools)
            if (const auto part = part_of(tool); part && !has(lesson_.scene, *part))
                doubts_.push_back("The tool " + std::string(hepatica::name_of(tool)) +
                                  " does nothing: the scene has no " + name_of(*part) + ".");
    }

    void look_at_places() {
        if (lesson_.patient != "any") return;
        for (const auto& [name, at] : points_of(lesson_))
            doubts_.push_back(name +
                              " is a point of one patient, but the lesson is for any: give it as "
                              "a share of the longest path, or choose the patient.");
    }

    void look_at_step(std::size_t index) {
        const LessonStep& step = lesson_.steps[index];
        const std::string where = step_in_words(lesson_, index);
        for (const Predicate& bound : step.goal) {
            look_at(bound, where + ", goal");
            look_at_goal(bound, where + ", goal");
        }
        const double until_its_end_s = least_time_s(lesson_, index + 1);
        for (const Predicate& bound : step.limits) {
            look_at(bound, where + ", limits");
            look_at_limit(bound, where + ", limits", index == 0);
            look_at_time(bound, where + ", limits", until_its_end_s, least_time_s(step));
        }
    }

    void doubt(const Predicate& bound, const std::string& where, const std::string& what) {
        doubts_.push_back(where + ": \"" + to_words(bound, marks_) + "\" " + what);
    }

    void look_at(const Predicate& bound, const std::string& where) {
        if (const auto part = part_of(bound.quantity); part && !has(lesson_.scene, *part))
            doubt(bound, where, "is never measured: the scene has no " + name_of(*part) + ".");
        if (asks_for_target(bound.quantity) && !lesson_.target)
            doubt(bound, where, "needs a target: say where it begins.");
        if (above_one(bound))
            doubt(bound, where, "is never decided: it is 1 at most. Give a bound from 0 to 1.");
    }

    // Skipped where the scene lacks the part or no tool is allowed: other doubts say so already.
    void look_at_goal(const Predicate& goal, const std::string& where) {
        const auto part = part_of(goal.quantity);
        if ((part && !has(lesson_.scene, *part)) || lesson_.tools.empty()) return;
        if (tool_is_missing(lesson_, goal))
            doubt(goal, where, "is out of reach: no tool that is allowed can do that.");
    }

    void look_at_limit(const Predicate& limit, const std::string& where, bool first) {
        if (breaks_at_once(lesson_, limit, first))
            doubt(limit, where, "is broken at once, before anything is done.");
    }

    // `least_s`: least time from the beginning to the last goal that counts; `step_s`: of the step
    // alone.
    void look_at_time(const Predicate& bound, const std::string& where, double least_s,
                      double step_s) {
        const bool of_step = bound.quantity == Quantity::step_time_s;
        const double needed_s = of_step ? step_s : least_s;
        if (bound.at_least || (!of_step && bound.quantity != Quantity::time_s)) return;
        if (needed_s > 0.0 && bound.bound > 0.0 && bound.bound <= needed_s)
            doubt(bound, where,
                  "is too short: what is to be held and waited for takes " +
                      to_words(Quantity::time_s, needed_s) + " or more.");
    }

    double longest_step_s() const {
        double longest_s = 0.0;
        for (const LessonStep& step : lesson_.steps)
            longest_s = std::max(longest_s, least_time_s(step));
        return longest_s;
    }

    const Lesson& lesson_;
    const std::filesystem::path& folder_;
    std::vector<std::string> marks_;
    std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> doubts_about(const Lesson& lesson, const std::filesystem::path& folder) {
    return Doubter(lesson, folder).all();
}

std::vector<std::string> doubts_about_places(const Lesson& lesson, const VesselTree& tree) {
    constexpr double beside_mm = 1.0;  // the radius describes the wall only approximately
    std::vector<std::string> doubts;
    for (const auto& [name, at] : points_of(lesson)) {
        const TreePoint nearest = nearest_point(tree, at);
        const Station station = station_at(tree.segments[static_cast<std::size_t>(nearest.segment)],
                                           nearest.arclength_mm);
        if (nearest.distance_mm <= station.radius_mm + beside_mm) continue;
        char away[32];
        std::snprintf(away, sizeof away, "%.0f mm", nearest.distance_mm - station.radius_mm);
        doubts.push_back(name + " lies " + away +
                         " beside the vessels of this patient, as if it was clicked on another "
                         "one: click on it again.");
    }
    return doubts;
}

std::vector<std::string> doubts_about_another(const Lesson& lesson, const VesselTree& shown) {
    constexpr double rounding_mm = 0.1;  // places are rounded to 0.1 mm in each coordinate
    std::vector<std::string> doubts;
    for (const auto& [name, at] : points_of(lesson))
        if (nearest_point(shown, at).distance_mm <= rounding_mm)
            doubts.push_back(name +
                             " is a point of the patient who is shown, but the lesson is for "
                             "another one: choose him, or click on it there.");
    return doubts;
}

}  // namespace hepatica
