// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons in the window: their menu, the one that is being played with its panel, and its end. The
// window lends a patient and takes the simulation.
#pragma once

#include <QDockWidget>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/lesson/course_standing.h"
#include "core/patient/patient_case.h"
#include "render/mark_actors.h"
#include "ui/flow_units.h"
#include "ui/lesson_play.h"
#include "ui/recording_guard.h"
#include "ui/settings.h"

class QMenu;

namespace hepatica {

class AttemptsDialog;
class CourseDialog;
class CourseEditor;
class LessonPanel;
class ResultsDialog;

class LessonDock : public QDockWidget {
  public:
    struct Ways {
        // The patient that is shown; null: none.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        // Else says why not: as where other vessels of his are still to come, which would end it.
        std::function<bool()> may_begin = [] { return true; };
        // What makes an attempt's steps.
        std::function<DeformBackEnd()> back_end = [] { return cpu_back_end(); };
        std::function<void()> open_built_in;  // shows it some time later, see patient_shown()
        std::function<void(const QString& case_folder)> open_case;  // likewise
        // In place of the one that runs; null: that of free play.
        std::function<void(std::unique_ptr<Simulation>)> use;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
        // Asks where to, and writes the report of a recording there.
        std::function<void(const std::filesystem::path& recording, const std::string& lesson)>
            report;
        // Shows a recording.
        std::function<void(const std::filesystem::path& recording, const std::string& lesson)>
            look_back;
        // Asks where to; `called`: what the file is called at first.
        std::function<void(const char* called, const std::string& csv)> save_table;
        std::function<void()> edit;  // shows the editor of lessons
        // This lesson is not begun: its places are elsewhere on its patient's vessels now.
        std::function<void(const std::filesystem::path& file, const Lesson& lesson,
                           const std::vector<std::string>& misfits)>
            unfit;
        std::function<void()> left;  // a lesson, for free play
        // See Settings::choose().
        std::function<QString(Settings::Kind, const Settings::Ask&)> choose =
            [](Settings::Kind, const Settings::Ask& ask) { return ask(QString()); };
        std::function<void(const QString& name)> named;  // the trainee, or nobody any more
        std::function<void()> ended = [] {};             // an attempt, by being passed or failed
        // This course is shown from now on; empty: the program's own.
        std::function<void(const std::filesystem::path& file)> course_chosen =
            [](const std::filesystem::path&) {};
    };

    LessonDock(Ways ways, std::filesystem::path recordings, QWidget* parent);
    ~LessonDock() override;

    // The lessons that come with the program, and "Open lesson...".
    void fill(QMenu& menu);
    // Begins on the patient that is shown, or opens the lesson's own first. `more_pass`: pass marks
    // beside the lesson's own, of a course. False where it cannot be read.
    bool start(const std::string& name, const std::vector<Predicate>& more_pass = {});
    // The same on the patient of this case, whom it goes with: opens him first.
    void start_on(const std::string& name, const QString& case_folder);
    // Plays it from a file of its own. That is no attempt: no result is kept, and the recording
    // goes when the next lesson is tried. False where that cannot be done.
    bool try_out(const Lesson& lesson);
    // A course: a file; empty: the one that comes with the program.
    void show_course(const std::filesystem::path& file);
    // The one that was chosen last, in an earlier run, too.
    void show_chosen_course() { show_course(std::filesystem::path(course_file_)); }
    void set_course(const std::filesystem::path& file) { course_file_ = file; }
    // Who passed what of the course shown last, of all whose attempts are kept.
    void show_results();
    CourseDialog& course() { return *course_; }
    // Edits the course shown last; of the program's own a copy, where the person wants it to lie.
    void edit_course();
    void begin_new_course();
    // There is another patient now, who was opened from this place: a lesson that waited for him
    // begins, one that ran is over.
    void patient_shown(bool built_in, const std::filesystem::path& asked_for);
    // The patient has other vessels now: a lesson that ran is over.
    void patient_corrected();
    // The patient that was being opened does not come: no lesson waits for him any more.
    void patient_not_shown() { waits_ = false; }
    bool playing() const { return watch_ != nullptr; }
    // The lesson that is being played and has not ended; null: none.
    const Lesson* running() const;
    // One runs, and something was done in it.
    bool begun() const { return running() != nullptr && !read_first_; }
    // Of the lesson that is being played or has ended.
    LessonStanding standing() const { return watch_->standing(); }
    bool recorded() const { return watch_->recorded(); }
    AttemptsDialog& attempts() { return *attempts_; }
    void set_units(FlowUnits units);
    // The clock stands while the task is read, and from the end of the attempt on: whether this is
    // the first thing that is done, with which it begins to run.
    bool begins_with(const Command& command);
    // Of attempts that end from now on; empty: nobody is named.
    void set_trainee(const QString& name);
    // At every figure's turn: how the lesson stands.
    void show_figures();
    // Another simulation stands in the place of the lesson's own, such as a review's: the panel
    // still says how the attempt went, and no mark is on those vessels.
    void play_hidden(const std::filesystem::path& shown);
    // The marks in a frame, numbered where there are more than one, and whether all steps that name
    // them are reached; none where no lesson's play is on the screen.
    std::vector<MarkView> marks_in(const Frame& frame) const;

  private:
    void find_next();                    // in the course shown last, or else the program's own
    bool read(const std::string& name);  // into lesson_; false where it failed, which is said
    void ask_for_lesson();
    void ask_for_course();
    void choose_course(const std::filesystem::path& file);
    CourseEditor& course_editor();
    void open_case(const std::filesystem::path& place);
    void end_play();            // the patient goes
    void drop_what_is_empty();  // a recording of an attempt in which nothing was done
    bool clock_stands() const { return read_first_ || stands_at_end_; }
    void begin();
    void leave();
    // Where lessons that are tried and their recordings are kept.
    std::filesystem::path tried() const { return recordings_ / "tried"; }
    std::filesystem::path next_recording() const;
    void name_last_attempt();
    void keep_result();  // of an attempt that has ended, once
    void show_attempts();

    Ways ways_;
    std::filesystem::path recordings_;  // folder
    LessonPanel* panel_;
    std::string name_;                       // of the lesson: an id or a file
    std::string watched_name_, shown_name_;  // of watch_'s; of the one whose attempts are shown
    std::optional<Lesson> lesson_;
    // Pass marks of a course, among those of lesson_ and of watch_'s.
    std::vector<Predicate> course_pass_, watched_course_pass_;
    bool waits_ = false;  // for its patient
    // Whom it waits for: a case; empty: the built-in patient, or whoever comes where it is for any.
    std::filesystem::path waits_for_;
    bool built_in_shown_ = false;
    std::filesystem::path course_file_;  // the one shown last; empty: the program's own
    std::optional<CourseLine> next_;     // the lesson after this one in its course
    std::string trainee_;
    std::shared_ptr<LessonWatch> watch_;
    std::unique_ptr<RecordingGuard> guard_;  // of watch_'s recording, while it grows
    bool result_kept_ = false;               // of watch_
    bool read_first_ = false;                // likewise: nothing was done yet
    bool stands_at_end_ = false;             // likewise: nothing was done since it has ended
    bool on_screen_ = false;                 // likewise: it is its simulation that the window shows
    AttemptsDialog* attempts_;
    CourseDialog* course_;
    ResultsDialog* results_ = nullptr;       // null until then
    CourseEditor* course_editor_ = nullptr;  // null until then
};

}  // namespace hepatica
