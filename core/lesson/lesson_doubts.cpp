// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_doubts.h"

#include <algorithm>

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

// The part without which a tool does nothing; settings need none of their own.
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

// The part without which a quantity never leaves its first value. How far a tool's tip goes needs
// none.
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

class Doubter {
  public:
    explicit Doubter(const Lesson& lesson) : lesson_(lesson), marks_(lesson.mark_names()) {}

    std::vector<std::string> all() {
        look_at_tools();
        look_at_places();
        for (std::size_t i = 0; i < lesson_.steps.size(); ++i) look_at_step(i);
        for (const Predicate& bound : lesson_.limits) look_at(bound, "the limit");
        for (const Predicate& bound : lesson_.pass) look_at(bound, "the pass mark");
        return std::move(doubts_);
    }

  private:
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
        const auto of_one_patient = [](const ScriptPlace& place) {
            return place.point_mm.has_value();
        };
        for (const LessonMark& mark : lesson_.marks)
            if (of_one_patient(mark.place))
                doubts_.push_back(
                    "\"" + mark.name +
                    "\" is a point of one patient, but the lesson is for any: give it "
                    "as a share of the longest path, or choose the patient.");
        if (lesson_.target && of_one_patient(*lesson_.target))
            doubts_.push_back(
                "The target is a point of one patient, but the lesson is for any: give it as a "
                "share of the longest path, or choose the patient.");
    }

    void look_at_step(std::size_t index) {
        const LessonStep& step = lesson_.steps[index];
        const std::string where = "step " + std::to_string(index + 1);
        for (const Predicate& bound : step.goal) look_at(bound, where);
        for (const Predicate& bound : step.limits) {
            look_at(bound, where);
            if (bound.quantity == Quantity::step_time_s && !bound.at_least &&
                bound.bound <= step.hold_s)
                doubts_.push_back("In " + where +
                                  " the goal is to be held for longer than the step may take.");
        }
    }

    void look_at(const Predicate& bound, const std::string& where) {
        const std::string asked = "\"" + to_words(bound, marks_) + "\" (" + where + ")";
        if (const auto part = part_of(bound.quantity); part && !has(lesson_.scene, *part))
            doubts_.push_back(asked + " is never measured: the scene has no " + name_of(*part) +
                              ".");
        if (asks_for_target(bound.quantity) && !lesson_.target)
            doubts_.push_back(asked + " needs a target: say where it begins.");
    }

    const Lesson& lesson_;
    std::vector<std::string> marks_;
    std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> doubts_about(const Lesson& lesson) {
    return Doubter(lesson).all();
}

}  // namespace hepatica
