// SPDX-License-Identifier: GPL-3.0-or-later
// A course is made and changed here: its name, its lessons in order, and the pass marks that it
// adds to theirs.
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

// UI thread.
class CourseEditor : public QDialog {
  public:
    struct Ways {
        // A lesson's file to add; the file for a course of that name, which is asked for in these
        // words. None: not after all.
        std::function<std::optional<std::filesystem::path>()> which_lesson;
        std::function<std::optional<std::filesystem::path>(const QString& question,
                                                           const std::string& name)>
            where_to_save;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
        // The course in this file is another one now.
        std::function<void(const std::filesystem::path& file)> written;
    };
    CourseEditor(Ways ways, QWidget* parent);

    // Shows the course of this file; of the program's own (an empty one) a copy, where the person
    // wants it to lie.
    void edit(const std::filesystem::path& file);
    // Begins a course without a lesson, called as its file, where the person wants it to lie.
    void begin_new();
    const CourseDocument& document() const { return document_; }

  private:
    void build();
    QWidget* build_lessons();
    QWidget* build_foot();
    void fill_menu(QMenu& menu);
    void save_copy(const Course& course, const std::filesystem::path& folder);
    void show_editor();
    // Does it to a copy of the course, which takes its place.
    void change(const std::string& what, const std::function<void(Course&)>& how);
    void add(const std::string& lesson);
    void add_file();
    void remove();
    void move(int by);
    // Tells what could not be done (false), and shows the course as it is then.
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
