// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/json_problem.h"
#include "core/base/text_file.h"
#include "core/base/written_json.h"
#include "core/flow/fluid.h"
#include "core/lesson/lesson_fields.h"
#include "core/lesson/predicate_json.h"
#include "core/lesson/tool_in_hand.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

// In the order of LessonTool.
constexpr std::array<const char*, 9> tool_names{"pull",  "sphere",   "capsule", "forceps", "hook",
                                                "blade", "cut_line", "inject",  "settings"};

LessonTool tool_from(const LessonFields& field) {
    const std::string name = field.text();
    const auto found =
        std::ranges::find_if(tool_names, [&](const char* tool) { return name == tool; });
    if (found != tool_names.end()) return static_cast<LessonTool>(found - tool_names.begin());
    std::string known;
    for (const char* const tool : tool_names)
        known += (known.empty() ? "" : ", ") + std::string(tool);
    field.refuse("is \"" + name + "\", which is no tool", "Choose from " + known);
}

PlaceTie tie_from(const LessonFields& fields) {
    PlaceTie tie{fields.need("at_mm").vector(), fields.need("radius_mm").number(), 0.0};
    if (fields.has("beyond_mm")) tie.beyond_mm = fields.need("beyond_mm").number();
    return tie;
}

std::optional<PlaceTie> tie_beside(const LessonFields& place) {
    if (!place.has("tied")) return std::nullopt;
    place.need("tied").know({"at_mm", "radius_mm", "beyond_mm"});
    return tie_from(place.need("tied"));
}

ScriptPlace place_from(const LessonFields& fields) {
    fields.know({"share_of_longest_path", "point_mm", "tied"});
    if (fields.has("share_of_longest_path") == fields.has("point_mm"))
        fields.refuse("needs either share_of_longest_path or point_mm", lesson_remedy);
    ScriptPlace place;
    if (fields.has("point_mm")) {
        place.point_mm = fields.need("point_mm").vector();
        return place;
    }
    const LessonFields share = fields.need("share_of_longest_path");
    const double value = share.number();
    if (!(value >= 0.0 && value <= 1.0))
        share.refuse("is " + share.dump(), "Give a share from 0 (the root) to 1 (the end)");
    place.share_of_longest_path = value;
    return place;
}

// Of a step of a lesson that allows these tools.
LessonTool step_tool_from(const LessonFields& field, const std::vector<LessonTool>& allowed) {
    const LessonTool tool = tool_from(field);
    if (!is_held(tool))
        field.refuse("is \"" + field.text() + "\", which is not held in the hand",
                     "Choose from pull, sphere, capsule, forceps, hook");
    if (std::ranges::find(allowed, tool) == allowed.end() && !field.unfinished())
        field.refuse("is \"" + field.text() + "\", which the lesson does not allow",
                     "Name it under \"tools\", too");
    return tool;
}

LessonStep step_from(const LessonFields& fields, const std::vector<std::string>& marks,
                     const std::vector<LessonTool>& allowed) {
    fields.know({"text", "hint", "tool", "goal", "hold_s", "limits"});
    LessonStep step;
    step.text = fields.need("text").text();
    if (fields.has("hint")) step.hint = fields.need("hint").text();
    step.goal = predicates_from(fields, "goal", marks);
    if (step.goal.empty() && !fields.unfinished())
        fields.refuse("has no goal", "Give \"goal\" at least one bound");
    if (fields.has("hold_s")) {
        const LessonFields hold = fields.need("hold_s");
        step.hold_s = hold.number();
        if (!(step.hold_s >= 0.0 && step.hold_s <= 3600.0))
            hold.refuse("is " + hold.dump(), "Give 0 to 3600 seconds");
    }
    step.limits = predicates_from(fields, "limits", marks);
    if (fields.has("tool")) step.tool = step_tool_from(fields.need("tool"), allowed);
    return step;
}

// Entries without "of", of earlier versions, are ignored: they refer to an order of actions that an
// edited setup does not keep.
std::vector<SetupTie> setup_ties_from(const LessonFields& fields) {
    std::vector<SetupTie> ties;
    for (const LessonFields& tie : fields.list()) {
        tie.know({"of", "at_mm", "radius_mm", "beyond_mm"});
        if (!tie.has("of")) continue;
        const LessonFields of = tie.need("of");
        if (of.has("from_mm")) {
            of.know({"from_mm", "to_mm"});
            const Blade blade{of.need("from_mm").vector(), of.need("to_mm").vector()};
            ties.push_back({blade, tie_from(tie)});
        } else {
            ties.push_back({place_from(of), tie_from(tie)});
        }
    }
    return ties;
}

bool takes_time(const ScriptAction& action) {
    const auto* move = action.command ? std::get_if<MoveGrab>(&*action.command) : nullptr;
    return action.at_s != 0.0 || action.over_s != 0.0 || (move != nullptr && move->over_s);
}

// The setup is applied in one step, so that a recording shows it.
Script setup_from(const LessonFields& fields) {
    const Json script{{"name", "setup"}, {"actions", fields.json()}};
    Script setup = script_of(script.dump(), fields.place());
    for (const ScriptAction& action : setup.actions)
        if (takes_time(action))
            fields.refuse("does something over time",
                          "Leave out at_s and over_s: it is done before the first step");
    return setup;
}

SceneSpec scene_of(const LessonFields& fields) {
    if (!fields.unfinished() || fields.has("deform") || fields.has("flow"))
        return scene_from_json(fields.json());
    Json with_flow = fields.json();  // scene_from_json() refuses an empty scene
    with_flow["flow"] = Json::object();
    SceneSpec scene = scene_from_json(with_flow);
    scene.flow.reset();
    return scene;
}

std::string drug_from(const LessonFields& drug) {
    const auto known = second_phases();
    if (std::ranges::find(known, drug.text(), &Phase::name) == known.end())
        drug.refuse("\"" + drug.text() + "\" is no drug",
                    "Choose one of: " + names_of_second_phases());
    return drug.text();
}

Lesson lesson_from(const LessonFields& fields) {
    fields.require_format("hepatica-lesson", lesson_remedy);
    fields.know({"format", "version", "name", "about", "patient", "scene", "setup", "setup_tied",
                 "tools", "marks", "drug", "target", "steps", "limits", "pass"},
                "id");
    Lesson lesson;
    lesson.name = fields.need("name").text();
    if (fields.has("id")) lesson.id = fields.need("id").text();
    if (fields.has("about")) lesson.about = fields.need("about").text();
    if (fields.has("patient")) lesson.patient = fields.need("patient").text();
    lesson.scene = scene_of(fields.need("scene"));
    if (fields.has("setup")) {
        lesson.setup = setup_from(fields.need("setup"));
        lesson.setup_json = fields.need("setup").dump();
    }
    if (fields.has("setup_tied")) lesson.setup_ties = setup_ties_from(fields.need("setup_tied"));
    if (fields.has("tools"))
        for (const LessonFields& tool : fields.need("tools").list())
            lesson.tools.push_back(tool_from(tool));
    if (fields.has("marks"))
        for (const auto& [name, place] : fields.need("marks").entries())
            lesson.marks.push_back({name, place_from(place), tie_beside(place)});
    if (fields.has("drug")) lesson.drug = drug_from(fields.need("drug"));
    if (fields.has("target")) {
        lesson.target = place_from(fields.need("target"));
        lesson.target_tie = tie_beside(fields.need("target"));
    }
    const std::vector<std::string> marks = lesson.mark_names();
    for (const LessonFields& step : fields.need("steps").list())
        lesson.steps.push_back(step_from(step, marks, lesson.tools));
    if (lesson.steps.empty()) fields.need("steps").refuse("is empty", lesson_remedy);
    lesson.limits = predicates_from(fields, "limits", marks);
    lesson.pass = predicates_from(fields, "pass", marks);
    return lesson;
}

std::string time_from(const LessonFields& field) {
    constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:ddZ";
    const std::string time = field.text();
    const auto fits = [](char given, char wanted) {
        return wanted == 'd' ? given >= '0' && given <= '9' : given == wanted;
    };
    if (!std::ranges::equal(time, pattern, fits))
        field.refuse("is " + field.dump() + ", not a time",
                     "Write it as \"2026-11-23T13:20:05Z\", or leave it out");
    return time;
}

Course course_from(const LessonFields& fields) {
    fields.require_format("hepatica-course", lesson_remedy);
    fields.know({"format", "version", "name", "lessons", "made_at"});
    Course course;
    course.name = fields.need("name").text();
    if (fields.has("made_at")) course.made_at = time_from(fields.need("made_at"));
    for (const LessonFields& entry : fields.need("lessons").list()) {
        entry.know({"lesson", "pass"});
        course.lessons.push_back({entry.need("lesson").text(), predicates_from(entry, "pass", {})});
    }
    return course;
}

Json json_of(const std::string& text, const std::string& place) {
    try {
        return parse_written<Json>(text);
    } catch (const Json::exception& error) {
        throw InputError(json_problem(error), place, lesson_remedy);
    }
}

// Parses a text with `from`. Errors of other rooms get the file's name.
template <class From>
auto parsed(const std::string& text, const std::string& place, const From& from,
            bool unfinished = false) {
    try {
        const Json json = json_of(text, place);
        return from(LessonFields(json, place, "", unfinished));
    } catch (const InputError& error) {
        if (error.place().starts_with(place)) throw;
        throw InputError(error.problem(), place + ": " + error.place(), error.remedy());
    }
}

}  // namespace

const char* name_of(LessonTool tool) {
    return tool_names[static_cast<std::size_t>(tool)];
}

std::vector<std::string> Lesson::mark_names() const {
    std::vector<std::string> names;
    for (const LessonMark& mark : marks) names.push_back(mark.name);
    return names;
}

Lesson lesson_of(const std::string& text, const std::string& place) {
    return parsed(text, place, lesson_from);
}

Lesson unfinished_lesson_of(const std::string& text, const std::string& place) {
    return parsed(text, place, lesson_from, true);
}

Lesson read_lesson(const std::filesystem::path& file) {
    return lesson_of(read_text_file(file, lesson_remedy), file.string());
}

Course course_of(const std::string& text, const std::string& place) {
    return parsed(text, place, course_from);
}

Course read_course(const std::filesystem::path& file) {
    return course_of(read_text_file(file, lesson_remedy), file.string());
}

std::optional<BuiltInLesson> built_in_lesson(const std::string& id) {
    for (const BuiltInLesson& lesson : built_in_lessons())
        if (id == lesson.id) return lesson;
    return std::nullopt;
}

Lesson find_lesson(const std::string& name) {
    const std::optional<BuiltInLesson> built_in = built_in_lesson(name);
    if (!built_in) return read_lesson(name);
    Lesson lesson = lesson_of(built_in->text, name);
    lesson.id = name;
    return lesson;
}

}  // namespace hepatica
