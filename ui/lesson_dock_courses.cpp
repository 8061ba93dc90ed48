// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the dock for courses: which one is shown, made, and what all have reached in it.
#include <QDateTime>
#include <QFileDialog>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/lesson/course_results.h"
#include "core/lesson/lesson_file.h"
#include "ui/core_words.h"
#include "ui/course_dialog.h"
#include "ui/file_name.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/course_editor.h"
#include "ui/lesson_panel.h"
#include "ui/paths.h"
#include "ui/questions.h"
#include "ui/results_dialog.h"
#include "ui/save_file_dialog.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// The course in this file, or the built-in one if `file` is empty.
Course course_in(const fs::path& file) {
    return file.empty() ? course_of(built_in_course(), "course") : read_course(file);
}

// The lesson of a course and those after it; empty if the course does not hold it or can no longer
// be read.
std::vector<CourseLine> lessons_from(const std::string& lesson, const fs::path& course) {
    try {
        auto lines = standing_of(course_in(course), course.parent_path(), {});
        lines.erase(lines.begin(), std::ranges::find(lines, lesson, &CourseLine::lesson));
        return lines;
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

void LessonDock::ask_for_course() {
    const QString file = ways_.choose(Settings::Kind::course, [this](const QString& start) {
        return QFileDialog::getOpenFileName(parentWidget(), Words::tr("Open course"), start,
                                            Words::tr("Courses (*.json)"));
    });
    if (!file.isEmpty()) show_course(to_path(file));
}

void LessonDock::show_course(const fs::path& file) {
    bool was_read = false;
    try {
        const Course course = course_in(file);
        was_read = true;
        choose_course(file);  // also where a lesson of it is gone: Edit course mends that
        course_->show_course(course.name, lines_of(course, file), trainee_, file.empty());
    } catch (...) {
        // If the chosen course is gone, the built-in one takes its place.
        if (!was_read && file == course_file_) choose_course({});
        ways_.failed(Words::tr("Open course"), std::current_exception());
    }
}

std::vector<CourseLine> LessonDock::lines_of(const Course& course, const fs::path& file) const {
    std::vector<Attempt> attempts = all_attempts(recordings_).list;
    if (!trainee_.empty())
        std::erase_if(attempts,
                      [this](const Attempt& attempt) { return attempt.name != trainee_; });
    return standing_of(course, file.parent_path(), attempts);
}

void LessonDock::choose_course(const fs::path& file) {
    course_file_ = file;
    ways_.course_chosen(file);
}

void LessonDock::show_results() {
    try {
        const Course course = course_in(course_file_);
        CourseResults results =
            results_of(course, course_file_.parent_path(), all_attempts(recordings_).list);
        if (results_ == nullptr)
            results_ = new ResultsDialog(
                [this](const std::string& csv) { ways_.save_table(*results_, "results", csv); },
                parentWidget());
        results_->show_results(course.name, std::move(results));
    } catch (...) {
        ways_.failed(Words::tr("Results of all"), std::current_exception());
    }
}

void LessonDock::edit_course() {
    course_editor().edit(course_file_);
}

void LessonDock::begin_new_course() {
    course_editor().begin_new();
}

CourseEditor& LessonDock::course_editor() {
    if (course_editor_ == nullptr) {
        CourseEditor::Ways ways;
        ways.which_lesson = [this]() -> std::optional<fs::path> {
            const QString file = ways_.choose(Settings::Kind::lesson, [this](const QString& start) {
                return QFileDialog::getOpenFileName(course_editor_, Words::tr("Add a lesson"),
                                                    start, Words::tr("Lessons (*.json)"));
            });
            return file.isEmpty() ? std::nullopt : std::optional(to_path(file));
        };
        ways.where_to_save = [this](const QString& question,
                                    const std::string& name) -> std::optional<fs::path> {
            const QString file = ways_.choose(Settings::Kind::course, [&](const QString& start) {
                return ask_where_to_save_file(
                    shown_of(*course_editor_, *parentWidget()), question,
                    start + "/" + as_file_name(translated(name), "course") + ".json",
                    Words::tr("Courses (*.json)"));
            });
            return file.isEmpty() ? std::nullopt : std::optional(to_path(file));
        };
        ways.failed = [this](const QString& doing, const std::exception_ptr& error) {
            tell_failure(shown_of(*course_editor_, *parentWidget()), doing, failure_of(error));
        };
        ways.written = [this](const fs::path& file) {
            choose_course(file);
            if (course_->isVisible()) show_course(file);
        };
        ways.now = [] {
            return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        };
        course_editor_ = new CourseEditor(std::move(ways), parentWidget());
    }
    return *course_editor_;
}

void LessonDock::find_next() {
    played_course_ = course_file_;
    std::vector<CourseLine> lines = lessons_from(name_, course_file_);
    if (lines.empty()) {
        played_course_ = fs::path();
        lines = lessons_from(name_, {});
    }
    if (lines.empty()) played_course_.reset();
    next_ = lines.size() > 1 ? std::optional(lines[1]) : std::nullopt;
    panel_->set_next(next_ ? next_->title : "");
    panel_->set_course_standing({});
}

void LessonDock::tell_course_standing() {
    if (!played_course_) return;
    try {
        const Course course = course_in(*played_course_);
        const std::vector<CourseLine> lines = lines_of(course, *played_course_);
        const std::ptrdiff_t passed = std::ranges::count_if(lines, &CourseLine::passed);
        const bool all = passed == std::ssize(lines);
        if (next_ && !all) return;
        panel_->set_next({});  // a course that is passed leads on to nothing
        const QString title = course_title(course.name), whose = whose_attempts(trainee_);
        panel_->set_course_standing(
            all ? Words::tr("✓ The course \"%1\" is passed by %2: all of its lessons are.")
                      .arg(title, whose)
                : Words::tr("This was the last lesson of the course \"%1\": %2 of %3 are passed "
                            "by %4.")
                      .arg(title, QString::number(passed), QString::number(lines.size()), whose));
    } catch (const InputError&) {
        return;  // the course can no longer be read: Lesson > Course says why
    }
}

}  // namespace hepatica
