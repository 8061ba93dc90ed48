// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/course_document.h"

#include <utility>

#include "core/lesson/course_standing.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {

namespace fs = std::filesystem;

void CourseDocument::open(const fs::path& file) {
    Course course = read_course(file);
    *this = {};
    file_ = fs::absolute(file).lexically_normal();
    course_ = std::move(course);
}

void CourseDocument::begin(const fs::path& file, const Course& course, const fs::path& folder) {
    const fs::path place = fs::absolute(file).lexically_normal();
    Course copy = course;
    for (CourseEntry& entry : copy.lessons)
        entry.lesson = entry_naming(lesson_named_by(entry.lesson, folder), place.parent_path());
    write_course(place, copy);
    *this = {};
    file_ = place;
    course_ = std::move(copy);
}

void CourseDocument::change(const std::string& what, Course course) {
    if (course == course_) return;
    if (what.empty() || what != changed_last_ || before_.empty()) before_.push_back(course_);
    changed_last_ = what;
    undone_.clear();
    course_ = std::move(course);
    write();
}

void CourseDocument::undo() {
    if (before_.empty()) return;
    undone_.push_back(std::exchange(course_, before_.back()));
    before_.pop_back();
    changed_last_.clear();
    write();
}

void CourseDocument::redo() {
    if (undone_.empty()) return;
    before_.push_back(std::exchange(course_, undone_.back()));
    undone_.pop_back();
    changed_last_.clear();
    write();
}

void CourseDocument::write() {
    written_ = false;
    write_course(file_, course_);
    written_ = true;
}

}  // namespace hepatica
