// SPDX-License-Identifier: GPL-3.0-or-later
// The course that is being edited, with undo and redo. Each change is written to the file at once
// and atomically, so that nothing is ever unsaved. No widgets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson_file.h"

namespace hepatica {

// Not thread-safe. A change that cannot be written throws InputError but stays, and is written with
// the next one.
class CourseDocument {
  public:
    // Throws InputError if the file cannot be read; the previous course then stays.
    void open(const std::filesystem::path& file);
    // Writes a copy of `course` to `file` and edits it. Relative lesson paths are resolved against
    // `folder`, the course's own folder (empty for the built-in course).
    void begin(const std::filesystem::path& file, const Course& course,
               const std::filesystem::path& folder);

    bool empty() const { return file_.empty(); }
    const std::filesystem::path& file() const { return file_; }
    const Course& course() const { return course_; }
    bool written() const { return written_; }

    // `what` names the changed value, such as "name"; consecutive changes with the same name are
    // undone together. Changes with an empty name are undone one by one.
    void change(const std::string& what, Course course);
    bool can_undo() const { return !before_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    void undo();  // no effect if there is nothing to undo
    void redo();

  private:
    void write();

    std::filesystem::path file_;
    Course course_;
    std::vector<Course> before_, undone_;  // the last element is the next to restore
    std::string changed_last_;
    bool written_ = true;
};

}  // namespace hepatica
