// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lessons and courses from JSON. docs/lessons.md explains the keys; assets/lessons has
// examples.
//   {"format": "hepatica-lesson", "version": 1, "name": ..., "id": ..., "about": ..., "patient":
//   "built-in",
//    "scene": {...}, "setup": [script actions], "tools": ["pull"],
//    "marks": {"the mark": {"share_of_longest_path": 0.5}}, "target": {"point_mm": [1, 2, 3]},
//    "steps": [{"text": ..., "hint": ..., "hold_s": 2, "goal": [
//        {"what": "moved_mm", "mark": "the mark", "at_least": 10}], "limits": [...]}],
//    "limits": [{"what": "force_mn", "at_most": 500}], "pass": [{"what": "time_s", "at_most": 60}]}
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// Throws InputError with the file, the place in it (steps[1].goal[0].at_most), the value and what
// it may be.
Lesson read_lesson(const std::filesystem::path& file);
// Same for a text, called `place` in errors.
Lesson lesson_of(const std::string& text, const std::string& place);
// Same for a lesson that is being edited, as text_of() writes it: texts may be empty, steps without
// a goal, bounds without their mark (-1), and the scene empty.
Lesson unfinished_lesson_of(const std::string& text, const std::string& place);

// A lesson of a course with additional pass marks.
struct CourseEntry {
    std::string lesson;  // id of a built-in lesson, or a file relative to the course's
    std::vector<Predicate> pass;
    bool operator==(const CourseEntry&) const = default;
};
struct Course {
    std::string name;
    std::vector<CourseEntry> lessons;  // in order; empty while it is being made
    // When it was made, UTC as Attempt::ended_at; attempts before do not count. Empty: all do.
    std::string made_at{};
    bool operator==(const Course&) const = default;
};

//   {"format": "hepatica-course", "version": 1, "name": ..., "lessons": [
//      {"lesson": "look_around", "pass": [{"what": "time_s", "at_most": 60}]}],
//    "made_at": "2026-11-23T13:20:05Z"}, the last of which may be left out.
// Throws InputError as above, also for pass marks that name a mark of a lesson.
Course read_course(const std::filesystem::path& file);
Course course_of(const std::string& text, const std::string& place);

// The built-in lessons in the order of their course.
struct BuiltInLesson {
    const char* id;
    const char* text;
};
std::vector<BuiltInLesson> built_in_lessons();
// None where no built-in lesson has this id.
std::optional<BuiltInLesson> built_in_lesson(const std::string& id);
const char* built_in_course();

// Reads a lesson by the id of a built-in one, which is then its id, or by its file. Throws
// InputError as above.
Lesson find_lesson(const std::string& name);

}  // namespace hepatica
