// SPDX-License-Identifier: GPL-3.0-or-later
// The main window: the 3D view in the middle (never floating), panels beside it, figures below. It
// places the panels and connects them: the PatientKeeper opens and saves patients, the newest frame
// goes to the view, and user actions go to the simulation as commands. UI thread only.
#pragma once

#include <QMainWindow>
#include <QStringList>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/lesson/lesson.h"
#include "ui/actions.h"
#include "ui/case_lock.h"
#include "ui/chosen_branch.h"
#include "ui/focus_of_view.h"
#include "ui/kept_play.h"
#include "ui/mouse_tool.h"
#include "ui/patient_keeper.h"
#include "ui/settings.h"
#include "ui/shelved_lessons.h"

class QTimer;

namespace hepatica {

class BranchDock;
class CaseEditing;
class CurvesDock;
class DialKeeper;
class EditPanel;
class FitKeeper;
class InjectPanel;
class LessonDock;
class DraftSlot;
class LessonEditor;
class LibraryDialog;
class LiverKeeper;
class MessageBar;
class MessageLog;
class PlayRecorder;
class PlaySounds;
class ProgressStrip;
class QualityPanel;
class ReviewDock;
class SecondView;
class StatusLine;
class ToolPanel;
class ViewLayout;
class ViewRuler;
class VolumeBar;
class VolumeKeeper;
class VtkWidget;
class Welcome;
struct PictureTime;

class MainWindow : public QMainWindow {
  public:
    using Patients = PatientKeeper::Ways;

    // If `questions` is missing, dialogs ask them.
    MainWindow(Settings& settings, Patients patients,
               std::optional<PatientKeeper::Questions> questions = std::nullopt);
    ~MainWindow() override;

    // Each starts its work and returns at once; failures appear above the view.
    void open(const OpenRequest& request);
    // A case, a CT or a recording (.hrec).
    void open(const QString& path);
    void save_case(const QString& folder);
    void cancel_job();
    bool busy() const { return keeper_->jobs().busy(); }

    bool has_patient() const { return patient_.has_value(); }
    // The newest frame that the view has taken over. Requires has_patient().
    const Frame& frame() const { return patient_->simulation->frame(); }
    const Workspace& workspace() const { return keeper_->workspace(); }
    VtkWidget& view() { return *view_; }
    ViewLayout& view_layout() { return *view_layout_; }
    VolumeKeeper& volume() { return *volume_; }
    MessageBar& messages() { return *messages_; }
    MessageLog& log() { return *log_; }
    LibraryDialog& library() { return *library_; }
    LessonDock& lessons() { return *lessons_; }
    LessonEditor& lesson_editor();  // made when first needed
    ReviewDock& review() { return *review_; }
    SecondView& second_view() { return *second_view_; }
    Actions& actions() { return *actions_; }

    // Writes the picture of the view. Throws InputError if the file cannot be written.
    void save_picture(const QString& file);
    // Writes a film of a review, with a progress bar and a cancel button; `go_to` shows a moment.
    // Throws InputError as write_film() does.
    void save_film(const std::filesystem::path& place, double end_s,
                   const std::function<void(double at_s)>& go_to);

    // The program that writes reports; by default the running one.
    void set_report_program(const QString& program) { report_program_ = program; }

    // Reports an error that nothing else has caught.
    void tell_failure_of_program(const std::exception_ptr& error) {
        fail("Hepatica", failure_of(error));
    }

    // Called once, when the first frame has been painted.
    void on_first_picture(std::function<void()> callback) { first_picture_ = std::move(callback); }
    // Called when this window closes to be replaced by another one, as a change of language needs,
    // with the shown patient if he can be opened again. Without a callback that is not offered.
    void on_begin_anew(std::function<void(const std::optional<OpenRequest>&)> callback) {
        begin_anew_ = std::move(callback);
    }

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    // Ends all jobs, or stays open if unsaved work would be lost and the user wants to stay.
    void closeEvent(QCloseEvent* event) override;
    // Says of Undo, where no correction can be undone, that it takes no cut of the play back.
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override { return focus_next_in_sight(*this, next); }

  private:
    // main_window.cpp: places and connects the panels.
    void build_view();
    void build_panels();
    void build_branches();
    void build_tool_bar();
    void make_keeper(Patients patients, PatientKeeper::Questions questions);
    void connect_files();
    void connect_play();
    void connect_tools();
    void connect_views();
    void connect_help();
    void connect_sounds();

    // main_window_views.cpp: panels that are shown and hidden, surroundings of the vessels,
    // measuring, appearance.
    void connect_panels();
    void make_room_beside(bool room);
    void connect_context();
    void connect_measuring();
    void follow_measuring();
    void remove_measurements();
    std::size_t show_in_slices(bool corrected);
    void tell_lost_diameters(std::size_t lost, const QString& said_before);
    // Legend and scale, rims at crossings, colours of the stretch.
    void connect_picture_parts();
    void connect_themes();
    void connect_mouse_schemes();
    void connect_units();
    void show_as_first(VtkWidget& view);  // the look and the mouse that were chosen
    void connect_languages();
    void speak(const QString& code);

    // main_window_volume.cpp: the CT as a volume around the vessels.
    void build_volume(QWidget* parent);
    void connect_volume();
    void say_why_no_volume(const Failure& failure);
    void show_volume_bar();
    void show_reading_of_volume();
    void show_volume_look();

    // main_window_slices.cpp: slices of the CT, and corrections.
    void build_slices(QWidget* parent);
    // Shows a CT while its vessels are reconstructed; null: there will be none. No effect while a
    // patient is shown.
    void show_image(std::shared_ptr<const Volume> ct);
    void end_image();
    // Whether corrections are allowed; if not, tells why, during a review in these words.
    bool may_correct(const char* why_not_in_review);
    void show_corrections_with_slices();
    void warn_of_stroke_outside(const BrushStroke& stroke);
    void say_obstacles_stay();
    void warn_of_tumour_outside(const TreeEdit& edit);
    void say_not_the_last();
    void follow_points();
    void undo();
    // Points in the slices that undo takes back.
    bool points_wait() const;
    std::pair<std::size_t, std::size_t> steps_of_corrections() const;
    void build_editing();
    void warn_of_corrections(const QString& text);  // of what they made doubtful, in lines
    // Of a link that may be a mistake, which can be undone there.
    void warn_of_link(const QString& text, const TreeEdit& link);
    void settle_link_warning();  // takes that away once the link is undone

    // main_window_lessons.cpp: lessons and reviews.
    void build_fits();
    void build_lessons();
    // Whether nothing forbids to begin a lesson; if not, tells why.
    bool may_begin_lesson();
    // Tries whether its recording can be written; says why not.
    bool may_record_lesson();
    // Begins a lesson's play with it; null: returns to free play.
    void use_for_lesson(std::unique_ptr<Simulation> simulation);
    void stop_after_lesson();
    void stop_drawing_a_vessel();
    // The lesson of this file does not fit the corrected vessels.
    void tell_not_played(const std::filesystem::path& file, const Lesson& lesson,
                         const std::vector<std::string>& misfits);
    void build_lesson_editor();
    // Opens a lesson's own patient; when the lesson is left, the former patient is offered again.
    void open_for_lesson(const OpenRequest& request);
    void show_whole_from_the_front();
    void show_whole();
    std::vector<std::uint8_t> target_of_lesson() const;
    // The shown patient, if he can be opened again.
    std::optional<OpenRequest> patient_from_where() const;
    void offer_patient_from_before();
    // These lessons no longer fit the corrected vessels.
    void tell_packed_lessons();
    // That another program has the case open, too.
    void tell_other_user();
    void tell_unfit(const std::vector<ShelvedLesson>& lessons);
    // Disables what the lesson being played, or a review, does not allow.
    void allow_tools();
    void wait_for_place();
    void end_waiting_for_place();
    void set_lesson_place(const SurfacePick& pick);
    void build_review();
    void dismiss_review_message();
    void dismiss_offered_report();  // of an attempt that another one follows

    // main_window_files.cpp: opening and saving.
    std::optional<std::filesystem::path> which_case();
    void ask_for_case();
    // Offers what earlier runs left: cases and edits, lessons, interrupted plays.
    void offer_unsaved_work();
    void offer_unsaved_lesson();
    void open_unsaved_work();
    void tell_unsaved_work_of_case();
    // Shows the play that waits for unsaved work to be opened, if it is.
    void look_back_when_opened();
    void connect_unsaved_work();
    void ask_for_ct(bool folder);
    // To look back on, or to compare with the one that is shown.
    std::optional<std::filesystem::path> ask_for_recording(const std::filesystem::path& shown = {});
    void ask_for_reconstruction();
    // Draws the seeds of the shown case, and remembers the masks of one that was just made.
    void show_what_it_was_made_with();
    void ask_where_to_save_picture();
    void ask_where_to_archive();
    QString proposed_file(const QString& called) const;
    // `asks`: the window in which the table is shown.
    void save_table(QWidget& asks, const QString& proposed, const std::string& csv);
    void save_plots(bool picture);
    bool shows_more_than(const std::filesystem::path& folder) const;
    // Copies the case of this place, at once or once what is shown of it is saved; or not, as the
    // person answers.
    void copy_case(const std::filesystem::path& place,
                   const std::function<void(bool lacks_work)>& copy);
    void ask_and_save_film(double end_s, const std::function<void(double at_s)>& go_to);
    // As a folder of pictures, whether there is ffmpeg or not.
    void ask_and_save_pictures(double end_s, const std::function<void(double at_s)>& go_to);
    void say_no_film();  // it was cancelled
    void remember(const std::filesystem::path& path);
    void fail(const QString& doing, const Failure& failure);
    bool may_end_lesson();
    void show_jobs();
    // Runs a task and shows its failure.
    void attempt(const QString& doing, const std::function<void()>& task);

    // main_window_back_end.cpp: what computes the steps.
    void connect_back_ends();
    void say_of_back_end(const std::string& words);
    void choose_back_end(const std::string& name);
    void measure_dial();

    // main_window_play.cpp: what is shown and played.
    void show_patient(LoadedPatient patient, bool corrected);
    void show_warnings(bool corrected);
    void tell_warnings();       // all that hold, above the view
    void dismiss_for_a_deed();  // what is said above the view, unless it is those
    void show_workspace();
    void show_title(const QString& patient);
    void show_welcome(bool visible);
    void show_caption(const QString& text);  // in the first view
    // The simulation announces new frames; nothing polls.
    void follow_simulation();
    void show_newest_frame();
    // Shows the marks of the lesson being played or edited. True if they have moved.
    bool show_marks();
    void sound(const Frame& frame);
    // Its line in the deformed body; empty where none is chosen in a table that is seen.
    std::vector<Vec3> line_of_chosen_branch();
    void keep_dial();  // stores it in the case
    // The dial is measured while nobody plays and no job runs.
    void tell_dial_keeper();
    // False during a lesson, where curves must not appear by themselves.
    bool plays_freely() const;
    void follow(const Frame& frame);  // updates the controls of the play
    // At most every quarter of a second, and only after a change.
    void show_figures_soon();
    void show_figures();
    void colour_by_segments(const std::vector<std::uint8_t>& of_branches);
    void show_hover(const SurfacePick& pick);
    void light_up(const TreePoint& under_mouse);
    // Moves the slices' crosshair to a vertex of the body at rest; -1: no effect.
    void lead_crosshair_to(int vertex);
    void inject(const SurfacePick& pick);
    void tear(MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke);
    void picture_shown(const PictureTime& time);
    void post(Command command);
    void set_mouse_mode(MouseMode mode);
    void back_to_pulling();
    void take_tool(const std::string& kind);
    // Replaces the running simulation; null: by free play.
    void use(std::unique_ptr<Simulation> simulation);
    void match_anatomy();

    // main_window_hints.cpp: what is said of the play.
    void show_message_of(const Frame& frame);
    // That the solver degraded a step: in the log, and where a force is shown.
    void tell_simplified();
    void say_rough_forces();
    // Tells at the window's foot and beside the pointer why an action in the view did nothing.
    void hint(const QString& text);
    void say_that_cuts_stay();
    void say_missed();
    // Those that the lesson allows, where the vessels may not be pulled.
    void say_tools_to_choose();
    void say_empty_grip(GripWatch::Seen seen);
    // False, and says so, in a step of a lesson that asks for the distance of a tool from a mark.
    bool step_lets_clicks_bring();
    QString guidance_of(MouseMode mode) const;  // what the mouse does, in the status bar
    QString words_without_pulling() const;      // what else it does
    // Whether there is a body to act on; actions that need one say so where there is none.
    void use_body(bool moves);

    // main_window_reports.cpp: reports of plays.
    void write_report(const std::filesystem::path& recording, const std::string& lesson);
    void write_report_into(const std::filesystem::path& chosen,
                           const std::filesystem::path& recording, const std::string& lesson);
    void offer_report(const std::filesystem::path& folder);

    // main_window_recording.cpp: recording of a free play.
    void connect_recording();
    void begin_recording();
    // Where his case lies: a recording does not say it.
    void remember_recorded_patient();
    void end_recording();
    void show_recording();

    Settings& settings_;
    std::shared_ptr<BackEnds> back_ends_;
    std::unique_ptr<Actions> actions_;
    VtkWidget* view_ = nullptr;
    ViewLayout* view_layout_ = nullptr;  // holds view_ and the slices of the CT
    SecondView* second_view_ = nullptr;  // of a recording beside another
    bool room_beside_ = false;
    std::vector<QDockWidget*> put_aside_;  // panels that make room for that, the raised ones last
    VolumeBar* volume_bar_ = nullptr;
    Welcome* welcome_ = nullptr;
    MessageBar* messages_ = nullptr;
    MessageLog* log_ = nullptr;
    LibraryDialog* library_ = nullptr;
    ProgressStrip* progress_ = nullptr;
    InjectPanel* inject_ = nullptr;
    EditPanel* edit_panel_ = nullptr;
    QualityPanel* quality_ = nullptr;
    ToolPanel* tool_panel_ = nullptr;
    CurvesDock* curves_ = nullptr;
    BranchDock* branches_ = nullptr;
    LessonDock* lessons_ = nullptr;
    LessonEditor* lesson_editor_ = nullptr;  // made when first needed
    std::unique_ptr<DraftSlot> draft_slot_;  // likewise
    ReviewDock* review_ = nullptr;
    std::unique_ptr<StatusLine> status_;
    QTimer* figures_timer_ = nullptr;
    std::atomic<bool> frame_waits_ = false;  // show_newest_frame() is scheduled
    std::optional<LoadedPatient> patient_;
    KeptPlay kept_play_;            // while a lesson or a review is shown
    bool shows_free_play_ = false;  // the simulation is that of free play
    std::unique_ptr<PlayRecorder> recorder_;
    std::filesystem::path told_folder_;  // case folder last told to the lesson editor
    int hovered_vertex_ = -1;            // of the frame
    ChosenBranch chosen_branch_;         // in the table
    double picture_ms_ = 0.0;
    std::string last_message_;
    bool solver_speaks_ = false;         // that is the solver's
    bool rough_told_ = false;            // of the force that is shown now
    std::set<std::string> solver_said_;  // sentences in the log, of this patient
    std::vector<std::string> warnings_;  // of the patient, that hold
    QString warnings_text_;              // as they were told last
    std::uint64_t warnings_origin_ = 0;  // of the workspace, whose warnings they are
    QString report_program_;
    std::filesystem::path report_to_offer_;       // written while a patient was opened
    std::filesystem::path play_to_look_back_on_;  // once the unsaved work is opened
    bool report_waited_ = false;                  // the next one that is offered did
    QString cuts_message_;                        // tells that cuts stay
    QString not_drawn_message_;                   // the last one, of a vessel drawn in the slices
    QString link_message_;                        // the last warning of a link
    TreeEdit doubtful_link_;                      // of which it is
    // Corrections and strokes when a point was set or taken back in the slices.
    std::pair<std::size_t, std::size_t> steps_at_points_;
    QString review_message_;  // why a recording could not be shown
    QString report_message_;  // where the newest report is
    QString unfit_message_;   // names lessons that no longer fit
    QString place_message_;   // asks for a place of a lesson
    // Of the last reconstruction asked for, until a patient is shown: it may fail.
    QStringList reconstruction_entries_;
    ReconstructOptions reconstruction_;         // likewise, with absolute paths
    std::vector<VesselSeed> seeds_of_entries_;  // in the slices when it was asked for
    std::function<void()> first_picture_;
    std::function<void(const std::optional<OpenRequest>&)> begin_anew_;
    bool begins_anew_ = false;  // after closing
    // The patient shown before a lesson opened its own.
    std::optional<OpenRequest> before_lesson_;
    std::optional<std::vector<LessonTool>> allowed_tools_;  // by the lesson being played
    bool forbids_for_review_ = false;                       // what a review forbids
    // Slices appeared by themselves and go when the patient is shown.
    bool slices_for_image_ = false;
    bool may_close_ = false;
    std::function<bool(const std::string& lesson)> end_lesson_;  // asks; see Questions
    std::function<bool()> end_play_;                             // likewise
    std::function<CopyAnswer(const std::string& title)> copy_of_unsaved_;
    bool in_close_event_ = false;
    std::unique_ptr<PatientKeeper> keeper_;
    std::unique_ptr<Recovery> recovery_;
    CaseLock case_lock_;
    std::unique_ptr<CaseEditing> editing_;
    std::unique_ptr<DialKeeper> dial_;
    std::unique_ptr<LiverKeeper> liver_;
    std::unique_ptr<FitKeeper> fits_;
    VolumeLook volume_look_;
    std::unique_ptr<VolumeKeeper> volume_;
    std::unique_ptr<ViewRuler> ruler_;
    std::unique_ptr<PlaySounds> sounds_;
};

}  // namespace hepatica
