// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_dock.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMenu>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>
#include <exception>
#include <limits>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/lesson/allowed_commands.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_doubts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/lesson_writer.h"
#include "ui/attempts_dialog.h"
#include "ui/core_words.h"
#include "ui/course_dialog.h"
#include "ui/lesson_editor/course_editor.h"
#include "ui/lesson_marks.h"
#include "ui/lesson_panel.h"
#include "ui/paths.h"
#include "ui/results_dialog.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

LessonDock::LessonDock(Ways ways, fs::path recordings, QWidget* parent)
    : QDockWidget(Words::tr("Lesson"), parent),
      ways_(std::move(ways)),
      recordings_(std::move(recordings)),
      panel_(new LessonPanel(
          {[this] { begin_again(); }, [this] { leave(); },
           [this] {
               if (watch_) ways_.report(watch_->recording(), watched_name_);
           },
           [this] {
               if (watch_) ways_.look_back(watch_->recording(), watched_name_);
           },
           [this] { show_attempts(); },
           [this] {
               if (next_) start(next_->lesson, next_->pass);
           },
           [this](const QString& name) {
               trainee_ = name.toStdString();
               ways_.named(name);
               name_last_attempt();
               note_interruption();
           },
           [this](const QString& words) { ways_.step(words); },
           [this](std::span<const LessonTool> tools) { return ways_.by_keys(tools); },
           [this](LessonTool tool) { return ways_.tool_and_key(tool); }})),
      attempts_(new AttemptsDialog(
          {[this](const fs::path& recording) { ways_.look_back(recording, shown_name_); },
           [this](const std::string& csv) { ways_.save_table(*attempts_, "attempts", csv); },
           [this](const std::exception_ptr& error) {
               ways_.failed(Words::tr("Mark an attempt"), error);
           }},
          parent)),
      course_(new CourseDialog([this](const CourseLine& line) { start(line.lesson, line.pass); },
                               [this] { show_course({}); }, parent)) {
    setObjectName("Lesson");
    setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(290);
    scroll->setWidget(panel_);
    setWidget(scroll);
    hide();
}

LessonDock::~LessonDock() = default;

void LessonDock::fill(QMenu& menu) {
    int number = 0;
    for (const BuiltInLesson& entry : built_in_lessons()) {
        const QString name = translated(find_lesson(entry.id).name);
        QAction* action = menu.addAction(QString("&%1  %2").arg(++number).arg(name));
        action->setObjectName(entry.id);
        connect(action, &QAction::triggered, this, [this, id = entry.id] { start(id); });
    }
    menu.addSeparator();
    connect(menu.addAction(Words::tr("&Course…")), &QAction::triggered, this,
            [this] { show_chosen_course(); });
    connect(menu.addAction(Words::tr("&Results of all…")), &QAction::triggered, this,
            [this] { show_results(); });
    connect(menu.addAction(Words::tr("&Open lesson…")), &QAction::triggered, this,
            [this] { ask_for_lesson(); });
    connect(menu.addAction(Words::tr("Open co&urse…")), &QAction::triggered, this,
            [this] { ask_for_course(); });
    connect(menu.addAction(Words::tr("&Edit lessons…")), &QAction::triggered, this,
            [this] { ways_.edit(); });
    connect(menu.addAction(Words::tr("Edi&t course…")), &QAction::triggered, this,
            [this] { edit_course(); });
    connect(menu.addAction(Words::tr("&New course…")), &QAction::triggered, this,
            [this] { begin_new_course(); });
}

void LessonDock::ask_for_lesson() {
    const QString file = ways_.choose(Settings::Kind::lesson, [this](const QString& start) {
        return QFileDialog::getOpenFileName(parentWidget(), Words::tr("Open lesson"), start,
                                            Words::tr("Lessons (*.json)"));
    });
    if (!file.isEmpty()) start(to_path(file).string());
}

bool LessonDock::read(const std::string& name) {
    try {
        lesson_ = find_lesson(name);
    } catch (...) {
        ways_.failed(Words::tr("Open lesson"), std::current_exception());
        return false;
    }
    const bool gives_up_try = waits_ && fs::path(name_).parent_path() == tried() &&
                              fs::path(name).parent_path() != tried();
    name_ = name;
    course_pass_.clear();
    waits_ = false;  // for the patient of the lesson that was chosen before
    if (gives_up_try) ways_.not_begun();
    return true;
}

void LessonDock::start_on(const std::string& name, const QString& case_folder) {
    if (!read(name)) return;
    open_case(to_path(case_folder));
}

void LessonDock::open_case(const fs::path& place) {
    waits_ = true;
    waits_for_ = fs::absolute(place).lexically_normal();
    ways_.open_case(to_text(waits_for_));
}

bool LessonDock::start(const std::string& name, const std::vector<Predicate>& more_pass) {
    if (!read(name)) return false;
    course_pass_ = add_new(more_pass, lesson_->pass);
    const bool any = lesson_->patient == "any";
    if (any ? ways_.patient() != nullptr : lesson_->patient == "built-in" && built_in_shown_)
        begin();
    else if (any || lesson_->patient == "built-in") {
        waits_ = true;
        waits_for_.clear();
        ways_.open_built_in();
    } else {
        open_case(fs::path(name).parent_path() / lesson_->patient);
    }
    return true;
}

void LessonDock::patient_shown(bool built_in, const fs::path& asked_for) {
    end_play();
    built_in_shown_ = built_in;
    // Not on another patient who was opened instead of the lesson's own.
    const bool fits = !waits_for_.empty() ? same_place(asked_for, waits_for_)
                                          : lesson_ && (lesson_->patient == "any" || built_in);
    // Later, when the patient is shown everywhere and the message that he is being opened is gone.
    const bool waited = std::exchange(waits_, false);
    if (waited && fits) return QTimer::singleShot(0, this, [this] { begin(); });
    hide();
    if (waited) ways_.not_begun();
}

void LessonDock::patient_corrected() {
    end_play();
    built_in_shown_ = false;
    hide();
}

// The writer may still have the file open.
void LessonDock::drop_what_is_empty() {
    std::error_code ignored;
    if (read_first_ && running() != nullptr) fs::remove(watch_->recording(), ignored);
}

void LessonDock::end_play() {
    give_up();
    watch_.reset();
    guard_.reset();
}

bool LessonDock::try_out(const Lesson& lesson) {
    const fs::path file = tried() / "lesson.json";
    try {
        fs::create_directories(tried());
        for (const auto& entry : fs::directory_iterator(tried()))
            if (extension_of(entry.path()) == ".hrec") fs::remove(entry.path());
        write_lesson(file, lesson);
    } catch (...) {
        ways_.failed(Words::tr("Try the lesson"), std::current_exception());
        return false;
    }
    return start(file.string());
}

fs::path LessonDock::next_recording() const {
    const fs::path folder = fs::path(name_).parent_path() == tried() ? tried() : recordings_;
    fs::create_directories(folder);
    const QString now = QDateTime::currentDateTimeUtc().toString("yyyyMMdd-HHmmss-zzz");
    return folder / (fs::path(name_).stem().string() + "-" + now.toStdString() + ".hrec");
}

void LessonDock::begin_again() {
    if (!watch_) return;  // his patient is gone
    lesson_ = watch_->lesson();
    name_ = watched_name_;
    course_pass_ = watched_course_pass_;
    waits_ = false;
    try_to_begin();  // where it cannot, what is played goes on
}

void LessonDock::begin() {
    if (!try_to_begin()) ways_.not_begun();
}

bool LessonDock::try_to_begin() {
    const std::shared_ptr<const PatientCase> patient = ways_.patient();
    if (!lesson_ || patient == nullptr || !ways_.may_begin()) return false;
    // Whoever tries a lesson is about to make it fit.
    const bool tries = fs::path(name_).parent_path() == tried();
    if (const auto wrong = misfits(*lesson_, patient->tree); !wrong.empty() && !tries) {
        hide();
        ways_.unfit(name_, *lesson_, wrong);
        return false;
    }
    give_up();  // the attempt before, unless it has ended
    try {
        Job job;
        LessonPlay play =
            LessonPlay::begin(*lesson_, patient, next_recording(), job, ways_.back_end());
        watch_ = std::move(play.watch);
        guard_ = std::make_unique<RecordingGuard>(watch_->recording());
        watched_name_ = name_;
        watched_course_pass_ = course_pass_;
        result_kept_ = false;
        read_first_ = true;
        stands_at_end_ = false;
        on_screen_ = true;
        ways_.use(std::move(play.simulation));
    } catch (...) {
        ways_.failed(Words::tr("Begin the lesson"), std::current_exception());
        return false;
    }
    find_next();
    panel_->set_trial(tries);
    panel_->begin(*lesson_, doubts_about_places(*lesson_, patient->tree));
    show_figures();
    show();
    raise();
    return true;
}

void LessonDock::leave() {
    give_up();
    watch_.reset();
    guard_.reset();
    lesson_.reset();
    hide();
    ways_.use(nullptr);
    ways_.left();
}

bool LessonDock::begins_with(const Command& command) {
    if (!watch_ || !on_screen_ || !clock_stands()) return false;
    const bool lets_it_run = std::holds_alternative<SetPaused>(command);
    const auto* drug = std::get_if<PlayDrug>(&command);
    const bool does_something =
        !objection_to(command, Lesson{}).empty() || (drug != nullptr && drug->playing);
    if (lets_it_run || does_something) {
        read_first_ = stands_at_end_ = false;
        show_figures();  // at once, whenever the next frame comes
    }
    note_interruption();
    return does_something;
}

const Lesson* LessonDock::running() const {
    const bool runs = watch_ && watch_->standing().outcome == LessonOutcome::running;
    return runs ? &watch_->lesson() : nullptr;
}

void LessonDock::set_units(FlowUnits units) {
    panel_->set_units(units);
    attempts_->set_units(units);
    show_figures();
}

void LessonDock::set_trainee(const QString& name) {
    trainee_ = name.toStdString();
    panel_->set_name(name);
}

void LessonDock::show_figures() {
    if (!watch_) return;
    if (watch_->recorded() && !result_kept_ && on_screen_) {
        stands_at_end_ = true;
        ways_.ended();
    }
    using InView = LessonPanel::InView;
    const InView in_view = on_screen_                                ? InView::play
                           : ways_.reviewed() == watch_->recording() ? InView::review
                                                                     : InView::other;
    keep_result();  // before the panel, which says what the course has come to
    panel_->show_standing(watch_->standing(), clock_stands(), in_view);
}

// A name that is given after the end is also noted in the last attempt, unless that has one.
void LessonDock::name_last_attempt() {
    if (!watch_ || !result_kept_ || trainee_.empty()) return;
    if (is_trial()) return;
    try {
        if (!name_beside(watch_->recording()).empty()) return;
        name_attempt(watch_->recording(), trainee_);
    } catch (...) {
        ways_.failed(Words::tr("Keep the result"), std::current_exception());
    }
}

void LessonDock::keep_result() {
    if (!watch_ || !watch_->recorded() || result_kept_) return;
    keep(watch_->standing());
    guard_.reset();
}

// What can be measured of it stands in its recording alone.
void LessonDock::note_interruption() {
    if (!guard_ || !watch_ || !begun()) return;
    LessonStanding standing = watch_->standing();
    standing.outcome = LessonOutcome::failed;
    standing.reasons = {interrupted_reason};
    Attempt attempt = result_of(standing);
    attempt.metrics.fill(std::numeric_limits<double>::quiet_NaN());
    try {
        guard_->note(attempt);
    } catch (...) {
        ways_.failed(Words::tr("Keep the result"), std::current_exception());
    }
}

// Else attempts that go wrong could be kept out of the learning curve.
void LessonDock::give_up() {
    keep_result();
    drop_what_is_empty();
    if (running() == nullptr || read_first_ || result_kept_) return;
    LessonStanding standing = watch_->standing();
    standing.outcome = LessonOutcome::failed;
    standing.reasons.push_back(Words::id("given up before the end"));
    keep(standing);
}

Attempt LessonDock::result_of(const LessonStanding& standing) const {
    const QString now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
    Attempt attempt = attempt_of(watch_->recording(), watch_->lesson().name, standing,
                                 now.toStdString(), watched_course_pass_);
    attempt.lesson_id = watch_->lesson().id;
    attempt.name = trainee_;
    return attempt;
}

void LessonDock::keep(const LessonStanding& standing) {
    result_kept_ = true;
    if (is_trial()) return;
    try {
        write_attempt(result_of(standing));
        tell_course_standing();
        ways_.kept();
    } catch (...) {
        ways_.failed(Words::tr("Keep the result"), std::current_exception());
    }
}

void LessonDock::show_attempts() {
    if (!watch_) return;
    shown_name_ = watched_name_;
    const std::string stem = fs::path(shown_name_).stem().string();
    attempts_->show_lesson({watch_->lesson().id, watch_->lesson().name}, recordings_, trainee_,
                           recordings_without_result(recordings_, stem));
}

// The panel would otherwise seem to describe the play that is shown instead.
void LessonDock::play_hidden(const fs::path& shown) {
    on_screen_ = false;
    if (watch_ && watch_->recording() != shown) hide();
    show_figures();
}

std::vector<MarkView> LessonDock::marks_in(const Frame& frame) const {
    if (!watch_ || !on_screen_) return {};
    const std::vector<Vec3> places = watch_->marks_in(frame);
    return views_of_marks(watch_->lesson(), places, watch_->standing().step);
}

}  // namespace hepatica
