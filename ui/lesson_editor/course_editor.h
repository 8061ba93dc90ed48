// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that edits a course: its name, the order of its lessons, and the pass marks that it adds
// to theirs.
#pragma once

#include <QDialog>
#include <functional>
#include <optional>
#include <string>

#include "ui/lesson_editor/course_document.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QMenu;
class QPushButton;
class QToolButton;

namespace hepatica {

class BoundsTable;

// UI thread only.
class CourseEditor : public QDialog {
  public:
    struct Ways {
        // Asks for a lesson file to add, and for the file of a course called `name` with the given
        // question. nullopt: cancelled.
        std::function<std::optional<std::filesystem::path>()> which_lesson;
        std::function<std::optional<std::filesystem::path>(const QString& question,
                                                           const std::string& name)>
            where_to_save;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
        // The course in this file was changed.
        std::function<void(const std::filesystem::path& file)> written;
        // The time, UTC as Course::made_at, of a course that is made now; empty: it has none.
        std::function<std::string()> now = [] { return std::string(); };
    };
    CourseEditor(Ways ways, QWidget* parent);
    ~CourseEditor() override;

    // Edits the course of this file. If `file` is empty and no course is open, edits a copy of the
    // built-in course at a place that the user chooses.
    void edit(const std::filesystem::path& file);
    // Creates a course without lessons, named after its file, where the user chooses.
    void begin_new();
    const CourseDocument& document() const { return document_; }

  private:
    void build();
    QWidget* build_lessons();
    QWidget* build_foot();
    void fill_menu(QMenu& menu);
    void save_copy(const Course& course, const std::filesystem::path& folder);
    void show_editor();
    // Applies `how` to a copy of the course, which then replaces it.
    void change(const std::string& what, const std::function<void(Course&)>& how);
    void add(const std::string& lesson);
    void add_file();
    void remove();
    void move(int by);
    // Runs `task`, reports an error (returns false), and shows the course as it is then.
    bool attempt(const QString& doing, const std::function<void()>& task);
    void show_course();
    void show_marks();
    void show_state();

    Ways ways_;
    CourseDocument document_;
    QLineEdit* name_;
    QListWidget* lessons_;
    BoundsTable* marks_;
    QLabel* state_;
    QToolButton* add_ = nullptr;
    QPushButton *up_ = nullptr, *down_ = nullptr, *remove_ = nullptr;
    QPushButton *undo_ = nullptr, *redo_ = nullptr;
};

}  // namespace hepatica
