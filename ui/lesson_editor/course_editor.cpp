// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/course_editor.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/course_standing.h"
#include "ui/core_words.h"
#include "ui/lesson_editor/bounds_table.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString title_of_lesson(const CourseEntry& entry, const std::filesystem::path& folder) {
    try {
        return translated(find_lesson(lesson_named_by(entry.lesson, folder)).name);
    } catch (const InputError&) {
        return Words::tr("%1 (cannot be read)").arg(to_text(entry.lesson));
    }
}

}  // namespace

CourseEditor::CourseEditor(Ways ways, QWidget* parent)
    : QDialog(parent),
      ways_(std::move(ways)),
      name_(new QLineEdit),
      lessons_(new QListWidget),
      marks_(new BoundsTable(
          Words::tr("Pass marks beside the lesson's own"), "coursePass",
          {Quantity::time_s, -1, false, 60.0},
          [this](const std::string& row, const std::vector<Predicate>& bounds) {
              const auto lesson = static_cast<std::size_t>(lessons_->currentRow());
              const std::string what = row.empty() ? "" : std::to_string(lesson) + "pass" + row;
              change(what, [&](Course& course) { course.lessons[lesson].pass = bounds; });
          })),
      state_(new QLabel) {
    setWindowTitle(Words::tr("Edit course"));
    resize_on_screen(*this, {640, 560});
    build();
}

// While the members are there: the field that loses the focus shows the course once more.
CourseEditor::~CourseEditor() {
    hide();
}

void CourseEditor::build() {
    name_->setObjectName("courseName");
    connect(name_, &QLineEdit::textEdited, this, [this](const QString& text) {
        if (!text.trimmed().isEmpty())  // a course must have a name
            change("name", [&](Course& course) { course.name = text.toStdString(); });
    });
    connect(name_, &QLineEdit::editingFinished, this, [this] { show_course(); });
    auto* form = new QFormLayout;
    form->addRow(Words::tr("&Name"), name_);
    marks_->setMinimumHeight(0);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->addWidget(marks_);
    rows->addStretch(1);
    scroll->setWidget(page);
    state_->setObjectName("courseState");
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(build_lessons(), 3);
    column->addWidget(scroll, 2);
    column->addWidget(state_);
    column->addWidget(build_foot());
}

QWidget* CourseEditor::build_lessons() {
    lessons_->setObjectName("courseLessons");
    lessons_->setAccessibleName(Words::tr("Lessons of the course"));
    connect(lessons_, &QListWidget::currentRowChanged, this, [this] { show_marks(); });
    auto* buttons = new QVBoxLayout;
    const auto button = [&](const QString& text, const char* name, auto&& does) {
        auto* made = new QPushButton(text);
        made->setObjectName(name);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, does);
        buttons->addWidget(made);
        return made;
    };
    add_ = new QToolButton;
    add_->setObjectName("courseAdd");
    add_->setText(Words::tr("&Add"));
    add_->setPopupMode(QToolButton::InstantPopup);
    add_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* menu = new QMenu(add_);
    fill_menu(*menu);
    add_->setMenu(menu);
    buttons->addWidget(add_);
    up_ = button(Words::tr("Move &up"), "courseUp", [this] { move(-1); });
    down_ = button(Words::tr("Move &down"), "courseDown", [this] { move(1); });
    remove_ = button(Words::tr("&Remove"), "courseRemove", [this] { remove(); });
    buttons->addStretch(1);
    auto* box = new QWidget;
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(lessons_, 1);
    line->addLayout(buttons);
    return box;
}

void CourseEditor::fill_menu(QMenu& menu) {
    for (const BuiltInLesson& entry : built_in_lessons()) {
        QAction* action = menu.addAction(translated(find_lesson(entry.id).name));
        action->setObjectName(entry.id);
        connect(action, &QAction::triggered, this, [this, id = entry.id] { add(id); });
    }
    menu.addSeparator();
    QAction* file = menu.addAction(Words::tr("A lesson's file…"));
    file->setObjectName("courseAddFile");
    connect(file, &QAction::triggered, this, [this] { add_file(); });
}

QWidget* CourseEditor::build_foot() {
    auto* box = new QDialogButtonBox(QDialogButtonBox::Close);
    const auto button = [&](const QString& text, const char* name, auto&& does) {
        QPushButton* made = box->addButton(text, QDialogButtonBox::ActionRole);
        made->setObjectName(name);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, does);
        return made;
    };
    const auto undo = [this] { attempt(Words::tr("Undo"), [this] { document_.undo(); }); };
    const auto redo = [this] { attempt(Words::tr("Redo"), [this] { document_.redo(); }); };
    undo_ = button(Words::tr("Undo"), "courseUndo", undo);
    redo_ = button(Words::tr("Redo"), "courseRedo", redo);
    button(Words::tr("Ne&w course…"), "courseNew", [this] { begin_new(); });
    button(Words::tr("Copy to another &file…"), "courseCopy",
           [this] { save_copy(document_.course(), document_.file().parent_path()); });
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, this, undo);
    connect(new QShortcut(QKeySequence::Redo, this), &QShortcut::activated, this, redo);
    box->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(box, &QDialogButtonBox::rejected, this, &QDialog::hide);
    return box;
}

void CourseEditor::edit(const std::filesystem::path& file) {
    if (file.empty() && document_.empty()) {
        Course own = course_of(built_in_course(), "course");
        own.name = translated(own.name).toStdString();
        save_copy(own, {});
        if (document_.empty()) return;
    } else if (!file.empty() && file != document_.file()) {
        if (!attempt(Words::tr("Edit course"), [&] { document_.open(file); })) return;
    }
    show_editor();
}

void CourseEditor::begin_new() {
    const std::string name = Words::tr("New course").toStdString();
    const auto file = ways_.where_to_save(Words::tr("Where should the new course be saved?"), name);
    if (!file) return;
    const std::string called = to_text(file->stem()).toStdString();
    if (attempt(Words::tr("New course"), [&] {
            document_.begin(*file, {called, {}, ways_.now()}, {});
        }))
        show_editor();
}

void CourseEditor::show_editor() {
    show();
    raise();
    activateWindow();
}

void CourseEditor::save_copy(const Course& course, const std::filesystem::path& folder) {
    const auto file = ways_.where_to_save(
        Words::tr("A copy of the course is edited: where to save it?"), course.name);
    if (!file) return;
    Course copy = course;
    copy.made_at = ways_.now();  // what was played before was not played for it
    attempt(Words::tr("Copy course"), [&] { document_.begin(*file, copy, folder); });
}

void CourseEditor::change(const std::string& what, const std::function<void(Course&)>& how) {
    if (document_.empty()) return;
    Course course = document_.course();
    how(course);
    attempt(Words::tr("Edit course"), [&] { document_.change(what, std::move(course)); });
}

void CourseEditor::add(const std::string& lesson) {
    if (document_.empty()) return;
    const int row = lessons_->currentRow() + 1;
    change("", [&](Course& course) {
        course.lessons.insert(
            course.lessons.begin() + row,
            CourseEntry{entry_naming(lesson, document_.file().parent_path()), {}});
    });
    lessons_->setCurrentRow(row);
}

// A file that cannot be read as a lesson is not added.
void CourseEditor::add_file() {
    const auto file = ways_.which_lesson();
    if (!file) return;
    try {
        read_lesson(*file);
    } catch (...) {
        return ways_.failed(Words::tr("Add a lesson"), std::current_exception());
    }
    add(std::filesystem::absolute(*file).string());
}

void CourseEditor::remove() {
    const int row = lessons_->currentRow();
    if (row < 0) return;
    change("", [row](Course& course) { course.lessons.erase(course.lessons.begin() + row); });
}

void CourseEditor::move(int by) {
    const int from = lessons_->currentRow(), to = from + by;
    if (from < 0 || to < 0 || to >= lessons_->count()) return;
    change("", [&](Course& course) {
        std::swap(course.lessons[static_cast<std::size_t>(from)],
                  course.lessons[static_cast<std::size_t>(to)]);
    });
    lessons_->setCurrentRow(to);
}

bool CourseEditor::attempt(const QString& doing, const std::function<void()>& task) {
    bool done = false;
    try {
        task();
        done = true;
        ways_.written(document_.file());
    } catch (...) {
        ways_.failed(doing, std::current_exception());
    }
    show_course();
    return done;
}

void CourseEditor::show_course() {
    const Course& course = document_.course();
    const QString name = QString::fromStdString(course.name);
    if (name_->text() != name) name_->setText(name);
    const int row = std::clamp(lessons_->currentRow(), 0,
                               std::max(0, static_cast<int>(course.lessons.size()) - 1));
    const QSignalBlocker blocker(lessons_);
    lessons_->clear();
    for (const CourseEntry& entry : course.lessons) {
        QString text = QString("%1.  %2")
                           .arg(lessons_->count() + 1)
                           .arg(title_of_lesson(entry, document_.file().parent_path()));
        if (!entry.pass.empty())
            text +=
                " " + Words::tr("(%n pass mark(s))", nullptr, static_cast<int>(entry.pass.size()));
        lessons_->addItem(text);
    }
    lessons_->setCurrentRow(row);
    show_marks();
    show_state();
}

void CourseEditor::show_marks() {
    const int row = lessons_->currentRow();
    const auto& lessons = document_.course().lessons;
    const bool any = row >= 0 && row < static_cast<int>(lessons.size());
    marks_->setEnabled(any);
    const std::vector<Predicate> shown =
        any ? lessons[static_cast<std::size_t>(row)].pass : std::vector<Predicate>();
    if (marks_->bounds() != shown) marks_->show_bounds(shown, {});
    up_->setEnabled(row > 0);
    down_->setEnabled(any && row + 1 < lessons_->count());
    remove_->setEnabled(any);
}

void CourseEditor::show_state() {
    undo_->setEnabled(document_.can_undo());
    redo_->setEnabled(document_.can_redo());
    const QString place = to_text(document_.file());
    state_->setText(document_.written()
                        ? Words::tr("Each change is in the file at once: %1").arg(place)
                        : Words::tr("⚠ The last change is not in the file yet: %1").arg(place));
}

}  // namespace hepatica
