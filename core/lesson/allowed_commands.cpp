// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/allowed_commands.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace hepatica {

namespace {

template <class T, class... Others>
constexpr bool is_one_of = (std::is_same_v<T, Others> || ...);

LessonTool tool_of(const AddTool& tool) {
    constexpr std::array<LessonTool, 3> others{LessonTool::sphere, LessonTool::forceps,
                                               LessonTool::hook};
    for (const LessonTool other : others)
        if (tool.kind == name_of(other)) return other;
    return LessonTool::capsule;
}

// Name of the tool in the window.
const char* words_of(LessonTool tool) {
    switch (tool) {
        case LessonTool::pull:
            return "pulling by hand";
        case LessonTool::sphere:
            return "probe";
        case LessonTool::capsule:
            return "rod probe";
        case LessonTool::forceps:
            return "forceps";
        case LessonTool::hook:
            return "hook";
        case LessonTool::blade:
            return "blade";
        case LessonTool::cut_line:
            return "cut line";
        case LessonTool::inject:
            return "injecting";
        case LessonTool::settings:
            break;
    }
    return "changing settings";
}

}  // namespace

std::string objection_to(const Command& command, const Lesson& lesson) {
    const auto unless = [&](LessonTool tool) -> std::string {
        if (std::ranges::find(lesson.tools, tool) != lesson.tools.end()) return "";
        return "the lesson does not allow this: " + std::string(words_of(tool));
    };
    return std::visit(
        [&](const auto& given) -> std::string {
            using T = std::decay_t<decltype(given)>;
            if constexpr (is_one_of<T, GrabPoint, GrabVertex>) return unless(LessonTool::pull);
            if constexpr (is_one_of<T, AddTool>) return unless(tool_of(given));
            if constexpr (is_one_of<T, Blade>) return unless(LessonTool::blade);
            if constexpr (is_one_of<T, CutLine>) return unless(LessonTool::cut_line);
            if constexpr (is_one_of<T, InjectDrug>) {
                if (!lesson.drug.empty() && given.second_phase != lesson.drug)
                    return "the lesson asks for another drug: " + lesson.drug;
                return unless(LessonTool::inject);
            }
            if constexpr (is_one_of<T, SetDrugTime, SetDrugSpeed, SetGravity, SetTether, SetWall,
                                    UseTear, UseContact>)
                return unless(LessonTool::settings);
            if constexpr (is_one_of<T, ResetWorld, RestoreSnapshot>)
                return "the play was taken back";
            return "";
        },
        command);
}

}  // namespace hepatica
