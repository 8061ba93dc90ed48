// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_writer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/lesson/predicate_json.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

Json place_json(const ScriptPlace& place) {
    if (place.share_of_longest_path)
        return {{"share_of_longest_path", *place.share_of_longest_path}};
    const Vec3 at = place.point_mm.value_or(Vec3::Zero());
    return {{"point_mm", {at.x(), at.y(), at.z()}}};
}

Json tie_json(const PlaceTie& tie) {
    Json json{{"at_mm", {tie.at_mm.x(), tie.at_mm.y(), tie.at_mm.z()}},
              {"radius_mm", tie.radius_mm}};
    if (tie.beyond_mm != 0.0) json["beyond_mm"] = tie.beyond_mm;
    return json;
}

Json place_json(const ScriptPlace& place, const std::optional<PlaceTie>& tie) {
    Json json = place_json(place);
    if (tie) json["tied"] = tie_json(*tie);
    return json;
}

Json json_of(const SetupPlace& place) {
    if (const auto* given = std::get_if<ScriptPlace>(&place)) return place_json(*given);
    const auto& [from, to] = std::get<Blade>(place);
    return {{"from_mm", {from.x(), from.y(), from.z()}}, {"to_mm", {to.x(), to.y(), to.z()}}};
}

Json ties_json(const std::vector<SetupTie>& ties) {
    Json json = Json::array();
    for (const auto& [of, tie] : ties) {
        if (!tie) continue;
        Json entry{{"of", json_of(of)}};
        entry.update(tie_json(*tie));
        json.push_back(std::move(entry));
    }
    return json;
}

Json step_json(const LessonStep& step, const std::vector<std::string>& marks) {
    Json json{{"text", step.text}};
    if (!step.hint.empty()) json["hint"] = step.hint;
    if (step.tool) json["tool"] = name_of(*step.tool);
    json["goal"] = json_of(step.goal, marks);
    if (step.hold_s != 0.0) json["hold_s"] = step.hold_s;
    if (!step.limits.empty()) json["limits"] = json_of(step.limits, marks);
    return json;
}

}  // namespace

std::string text_of(const Lesson& lesson) {
    const std::vector<std::string> marks = lesson.mark_names();
    Json json{{"format", "hepatica-lesson"}, {"version", 1}, {"name", lesson.name}};
    if (!lesson.id.empty()) json["id"] = lesson.id;
    if (!lesson.about.empty()) json["about"] = lesson.about;
    json["patient"] = lesson.patient;
    json["scene"] = to_json(lesson.scene);
    if (!lesson.setup_json.empty()) json["setup"] = Json::parse(lesson.setup_json);
    if (Json ties = ties_json(lesson.setup_ties); !ties.empty()) json["setup_tied"] = ties;
    json["tools"] = Json::array();
    for (const LessonTool tool : lesson.tools) json["tools"].push_back(name_of(tool));
    if (!lesson.marks.empty()) json["marks"] = Json::object();
    for (const LessonMark& mark : lesson.marks)
        json["marks"][mark.name] = place_json(mark.place, mark.tie);
    if (!lesson.drug.empty()) json["drug"] = lesson.drug;
    if (lesson.target) json["target"] = place_json(*lesson.target, lesson.target_tie);
    json["steps"] = Json::array();
    for (const LessonStep& step : lesson.steps) json["steps"].push_back(step_json(step, marks));
    if (!lesson.limits.empty()) json["limits"] = json_of(lesson.limits, marks);
    if (!lesson.pass.empty()) json["pass"] = json_of(lesson.pass, marks);
    return json.dump(2) + "\n";
}

void write_lesson(const std::filesystem::path& file, const Lesson& lesson) {
    std::vector<std::string> names = lesson.mark_names();
    std::ranges::sort(names);
    if (const auto twice = std::ranges::adjacent_find(names); twice != names.end())
        throw InputError("has two marks called \"" + *twice + "\"", file.string(),
                         "Give each mark a name of its own");
    const std::string text = text_of(lesson);
    lesson_of(text, file.string());
    write_text_atomically(file, text);
}

std::string text_of(const Course& course) {
    Json json{{"format", "hepatica-course"}, {"version", 1}, {"name", course.name}};
    if (!course.made_at.empty()) json["made_at"] = course.made_at;
    json["lessons"] = Json::array();
    for (const CourseEntry& entry : course.lessons) {
        Json lesson{{"lesson", entry.lesson}};
        if (!entry.pass.empty()) lesson["pass"] = json_of(entry.pass, {});
        json["lessons"].push_back(std::move(lesson));
    }
    return json.dump(2) + "\n";
}

void write_course(const std::filesystem::path& file, const Course& course) {
    const std::string text = text_of(course);
    course_of(text, file.string());
    write_text_atomically(file, text);
}

}  // namespace hepatica
