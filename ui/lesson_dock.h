// SPDX-License-Identifier: GPL-3.0-or-later
// Dock for lessons: their menu, the lesson being played with its panel, results and courses. The
// window provides the patient and runs the simulation.
#pragma once

#include <QDockWidget>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/lesson/attempts.h"
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

// UI thread only.
class LessonDock : public QDockWidget {
  public:
    struct Ways {
        // The shown patient; null: none.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        // Whether a lesson may begin; if not, tells why, such as a correction that would end it.
        std::function<bool()> may_begin = [] { return true; };
        // How these tools are used without a mouse, in lines.
        std::function<QString(std::span<const LessonTool>)> by_keys =
            [](std::span<const LessonTool>) { return QString(); };
        // The name of a tool with the key that takes it.
        std::function<QString(LessonTool)> tool_and_key = [](LessonTool) { return QString(); };
        // Computes the steps of an attempt.
        std::function<DeformBackEnd()> back_end = [] { return cpu_back_end(); };
        std::function<void()> open_built_in;  // asynchronous; patient_shown() follows
        std::function<void(const QString& case_folder)> open_case;  // likewise
        // Replaces the running simulation; null: by free play.
        std::function<void(std::unique_ptr<Simulation>)> use;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
        // Asks for a place and writes the report of a recording there.
        std::function<void(const std::filesystem::path& recording, const std::string& lesson)>
            report;
        // Shows a recording in a review.
        std::function<void(const std::filesystem::path& recording, const std::string& lesson)>
            look_back;
        // Asks in front of the window `asks` for a place and saves a table; `called` is the
        // suggested file name.
        std::function<void(QWidget& asks, const char* called, const std::string& csv)> save_table;
        std::function<void()> edit;  // shows the lesson editor
        // This lesson was not begun, because its places no longer lie where they were on the
        // vessels.
        std::function<void(const std::filesystem::path& file, const Lesson& lesson,
                           const std::vector<std::string>& misfits)>
            unfit;
        std::function<void()> left;               // the lesson was left for free play
        std::function<void()> not_begun = [] {};  // a lesson cannot begin; told why already
        // See Settings::choose().
        std::function<QString(Settings::Kind, const Settings::Ask&)> choose =
            [](Settings::Kind, const Settings::Ask& ask) { return ask(QString()); };
        // The trainee has another name; may be empty.
        std::function<void(const QString& name)> named;
        // A later step begins.
        std::function<void(const QString& words)> step = [](const QString&) {};
        std::function<void()> ended = [] {};  // the attempt was passed or failed
        std::function<void()> kept = [] {};   // its result was written
        // The recording that is looked back on now; empty: none.
        std::function<std::filesystem::path()> reviewed = [] { return std::filesystem::path(); };
        // This course is shown from now on; empty: the built-in one.
        std::function<void(const std::filesystem::path& file)> course_chosen =
            [](const std::filesystem::path&) {};
    };

    LessonDock(Ways ways, std::filesystem::path recordings, QWidget* parent);
    ~LessonDock() override;

    // Fills the Lesson menu.
    void fill(QMenu& menu);
    // Begins on the shown patient if he fits, else opens the lesson's own first. `more_pass` are
    // additional pass marks of a course. False if the lesson cannot be read.
    bool start(const std::string& name, const std::vector<Predicate>& more_pass = {});
    // Opens the patient of this case, with whom the lesson goes, and begins on him.
    void start_on(const std::string& name, const QString& case_folder);
    // Plays a lesson from a temporary file. That is no attempt: no result is kept, and the
    // recording is deleted when the next lesson is tried. False on failure.
    bool try_out(const Lesson& lesson);
    // Shows the course in a file; empty: the built-in one.
    void show_course(const std::filesystem::path& file);
    // The course chosen last, possibly in an earlier run.
    void show_chosen_course() { show_course(std::filesystem::path(course_file_)); }
    void set_course(const std::filesystem::path& file) { course_file_ = file; }
    // The results of all trainees in the course chosen last.
    void show_results();
    CourseDialog& course() { return *course_; }
    // Edits the course chosen last; of the built-in one a copy, at a place that the user chooses.
    void edit_course();
    void begin_new_course();
    // Another patient, or other vessels of his, are about to be shown: the play ends, because its
    // marks are vertices of these ones. patient_shown() or patient_corrected() follows.
    void end_play();
    // Another patient is shown, who was opened from this place. A lesson that waited for him
    // begins; a running one ends.
    void patient_shown(bool built_in, const std::filesystem::path& asked_for);
    // The patient has other vessels: a running lesson ends.
    void patient_corrected();
    // The patient being opened will not come: no lesson waits for him any more.
    void patient_not_shown() {
        if (std::exchange(waits_, false)) ways_.not_begun();
    }
    bool playing() const { return watch_ != nullptr; }
    // The view shows the lesson's play, and no review or free play after it.
    bool shows_play() const { return playing() && on_screen_; }
    // The lesson whose play the view shows, also after its end; null: none.
    const Lesson* shown() const { return shows_play() ? &watch_->lesson() : nullptr; }
    // The lesson being played that has not ended; null: none.
    const Lesson* running() const;
    // An attempt runs in which something was done. What is tried from the editor is none.
    bool begun() const { return running() != nullptr && !read_first_ && !is_trial(); }
    // Of the lesson being played or ended. Requires playing().
    LessonStanding standing() const { return watch_->standing(); }
    bool recorded() const { return watch_->recorded(); }
    // Keeps what was begun and has not ended as an attempt that was not passed, once; deletes the
    // recording of one in which nothing was done. For whatever ends the lesson's play.
    void give_up();
    AttemptsDialog& attempts() { return *attempts_; }
    void set_units(FlowUnits units);
    // The clock stands while the task is read and after the end of the attempt. Returns whether
    // this command is the first action, which starts the clock.
    bool begins_with(const Command& command);
    // Name in attempts that end from now on; empty: none.
    void set_trainee(const QString& name);
    // Called regularly to show how the lesson stands.
    void show_figures();
    // Another simulation replaces the lesson's, such as a review. The panel still shows the
    // attempt, if `shown` is its recording, but no marks are drawn.
    void play_hidden(const std::filesystem::path& shown);
    // The marks in a frame, numbered if there are several, with whether all steps that name them
    // are reached; empty if no lesson's play is on the screen.
    std::vector<MarkView> marks_in(const Frame& frame) const;

  private:
    // In the chosen course where it holds the lesson, else in the built-in one.
    void find_next();
    // Says in the panel how the course stands, after its last lesson or once all are passed.
    void tell_course_standing();
    // The trainee's standing in the course of this file.
    std::vector<CourseLine> lines_of(const Course& course, const std::filesystem::path& file) const;
    bool read(const std::string& name);  // into lesson_; on failure reports it and returns false
    void ask_for_lesson();
    void ask_for_course();
    void choose_course(const std::filesystem::path& file);
    CourseEditor& course_editor();
    void open_case(const std::filesystem::path& place);
    void drop_what_is_empty();  // deletes the recording of an attempt in which nothing was done
    bool clock_stands() const { return read_first_ || stands_at_end_; }
    void begin();
    bool try_to_begin();
    void begin_again();  // the lesson of the panel, whatever waits for its patient
    void leave();
    // Folder of lessons being tried and their recordings.
    std::filesystem::path tried() const { return recordings_ / "tried"; }
    bool is_trial() const { return watch_->recording().parent_path() == tried(); }
    std::filesystem::path next_recording() const;
    void name_last_attempt();
    // The play that goes on, as it counts if the program ends by a crash.
    void note_interruption();
    Attempt result_of(const LessonStanding& standing) const;
    void keep_result();  // of an attempt that has ended, once
    void keep(const LessonStanding& standing);
    void show_attempts();

    Ways ways_;
    std::filesystem::path recordings_;  // a folder
    LessonPanel* panel_;
    std::string name_;  // of the lesson: an id or a file
    // The lesson of watch_, and the one whose attempts are shown.
    std::string watched_name_, shown_name_;
    std::optional<Lesson> lesson_;
    // Pass marks of a course that were added to lesson_ and to the lesson of watch_.
    std::vector<Predicate> course_pass_, watched_course_pass_;
    bool waits_ = false;  // for its patient
    // The case that it waits for; empty: the built-in patient, or any patient if the lesson is for
    // any.
    std::filesystem::path waits_for_;
    bool built_in_shown_ = false;
    std::filesystem::path course_file_;  // chosen last; empty: the built-in one
    // The course that the lesson of watch_ belongs to (empty: the built-in one), and the lesson
    // after it there.
    std::optional<std::filesystem::path> played_course_;
    std::optional<CourseLine> next_;
    std::string trainee_;
    std::shared_ptr<LessonWatch> watch_;
    std::unique_ptr<RecordingGuard> guard_;  // of the recording of watch_ while it is written
    bool result_kept_ = false;               // of watch_
    bool read_first_ = false;                // likewise: nothing was done yet
    bool stands_at_end_ = false;             // likewise: nothing was done since it ended
    bool on_screen_ = false;                 // likewise: the window shows its simulation
    AttemptsDialog* attempts_;
    CourseDialog* course_;
    ResultsDialog* results_ = nullptr;       // made when first needed
    CourseEditor* course_editor_ = nullptr;  // likewise
};

}  // namespace hepatica
