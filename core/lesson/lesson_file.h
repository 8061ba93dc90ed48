// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons and courses as JSON. docs/lessons.md says what each key means; assets/lessons has seven.
//   {"format": "hepatica-lesson", "version": 1, "name": ..., "about": ..., "patient": "built-in",
//    "scene": {...}, "setup": [script actions], "tools": ["pull"],
//    "marks": {"the mark": {"share_of_longest_path": 0.5}}, "target": {"point_mm": [1, 2, 3]},
//    "steps": [{"text": ..., "hint": ..., "hold_s": 2, "goal": [
//        {"what": "moved_mm", "mark": "the mark", "at_least": 10}], "limits": [...]}],
//    "limits": [{"what": "force_mn", "at_most": 500}], "pass": [{"what": "time_s", "at_most": 60}]}
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// Throws InputError that names the file, the place in it (steps[1].goal[0].at_most), the value and
// what it may be.
Lesson read_lesson(const std::filesystem::path& file);
// The same of a text, called `place` in errors.
Lesson lesson_of(const std::string& text, const std::string& place);
// The same of a lesson that is being made: texts may be empty, steps without a goal, bounds without
// their mark (-1), and the scene of nothing, as text_of() writes them.
Lesson unfinished_lesson_of(const std::string& text, const std::string& place);

// A lesson of a course, with pass marks beside its own.
struct CourseEntry {
    std::string lesson;  // a file, relative to the course's; or the name of a built-in one
    std::vector<Predicate> pass;
    bool operator==(const CourseEntry&) const = default;
};
struct Course {
    std::string name;
    std::vector<CourseEntry> lessons;  // in this order; empty while it is being made
    bool operator==(const Course&) const = default;
};

//   {"format": "hepatica-course", "version": 1, "name": ..., "lessons": [
//      {"lesson": "look_around", "pass": [{"what": "time_s", "at_most": 60}]}]}
// Throws InputError as above. Pass marks of a course name no marks of a lesson.
Course read_course(const std::filesystem::path& file);
Course course_of(const std::string& text, const std::string& place);

// The lessons that come with the program: their texts, in the order of their course.
struct BuiltInLesson {
    const char* id;
    const char* text;
};
std::vector<BuiltInLesson> built_in_lessons();
const char* built_in_course();

// What a person names: the id of a built-in lesson, or a file.
Lesson find_lesson(const std::string& name);

}  // namespace hepatica
