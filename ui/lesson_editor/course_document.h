// SPDX-License-Identifier: GPL-3.0-or-later
// A course that is being edited, with what can be undone. Each change is written to its file at
// once, whole or not at all, so that there is nothing that could be lost unsaved. No widgets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson_file.h"

namespace hepatica {

// Not thread-safe. What cannot be written is an InputError; the change stands all the same, and
// the next one is written with it.
class CourseDocument {
  public:
    // Throws InputError where it cannot be read; then the one before stays.
    void open(const std::filesystem::path& file);
    // Begins a file with a copy of a course that lies in `folder` (empty: the program's own).
    void begin(const std::filesystem::path& file, const Course& course,
               const std::filesystem::path& folder);

    bool empty() const { return file_.empty(); }
    const std::filesystem::path& file() const { return file_; }
    const Course& course() const { return course_; }
    bool written() const { return written_; }

    // `what` is changed, such as "name": one change after another of the same is undone at once.
    // Empty: each by itself.
    void change(const std::string& what, Course course);
    bool can_undo() const { return !before_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    void undo();  // nothing where there is nothing to undo
    void redo();

  private:
    void write();

    std::filesystem::path file_;
    Course course_;
    std::vector<Course> before_, undone_;  // the last one is the next
    std::string changed_last_;
    bool written_ = true;
};

}  // namespace hepatica
