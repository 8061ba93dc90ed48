// SPDX-License-Identifier: GPL-3.0-or-later
// The window: the patient in the middle (never floating), panels beside, figures below. It places
// the panels and connects them: patients come and go through the PatientKeeper, the newest frame
// goes to the view, and what the user does is sent to the simulation as commands.
#pragma once

#include <QMainWindow>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/lesson/lesson.h"
#include "ui/actions.h"
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

    // Without `questions` they are asked in dialogs.
    MainWindow(Settings& settings, Patients patients,
               std::optional<PatientKeeper::Questions> questions = std::nullopt);
    ~MainWindow() override;

    // Each starts its work and returns at once; failures appear above the view.
    void open(const OpenRequest& request);
    void open(const QString& path);
    void save_case(const QString& folder);
    void cancel_job();
    bool busy() const { return keeper_->jobs().busy(); }

    bool has_patient() const { return patient_.has_value(); }
    // The newest frame that the view has taken over; only while there is a patient.
    const Frame& frame() const { return patient_->simulation->frame(); }
    const Workspace& workspace() const { return keeper_->workspace(); }
    VtkWidget& view() { return *view_; }
    ViewLayout& view_layout() { return *view_layout_; }
    VolumeKeeper& volume() { return *volume_; }
    MessageBar& messages() { return *messages_; }
    MessageLog& log() { return *log_; }
    LibraryDialog& library() { return *library_; }
    LessonDock& lessons() { return *lessons_; }
    LessonEditor& lesson_editor();  // made when it is wanted first
    ReviewDock& review() { return *review_; }
    SecondView& second_view() { return *second_view_; }
    Actions& actions() { return *actions_; }

    // Writes what the view shows. Throws InputError where the file cannot be written.
    void save_picture(const QString& file);
    // Writes what is shown at each moment of a review, with a bar and a button that ends it. Throws
    // InputError as write_film() does.
    void save_film(const std::filesystem::path& place, double end_s,
                   const std::function<void(double at_s)>& go_to);

    // The program that writes reports; at first the one that runs.
    void set_report_program(const QString& program) { report_program_ = program; }

    // What none of its parts has caught.
    void tell_failure_of_program(const std::exception_ptr& error) {
        fail("Hepatica", failure_of(error));
    }

    // Called once, when the first frame has been painted.
    void on_first_picture(std::function<void()> callback) { first_picture_ = std::move(callback); }
    // Called when this window closes and another one shall be made in its place, as another
    // language needs, with who was shown here where he can be opened again. Without it that is not
    // offered.
    void on_begin_anew(std::function<void(const std::optional<OpenRequest>&)> callback) {
        begin_anew_ = std::move(callback);
    }

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    // Ends all jobs, or stays open where something unsaved would be lost and the user says so.
    void closeEvent(QCloseEvent* event) override;

  private:
    // main_window.cpp: places and connects.
    void build_view();
    void build_panels();
    void build_branches();
    void build_tool_bar();
    void make_keeper(Patients patients, PatientKeeper::Questions questions);
    void connect_files();
    void connect_play();
    void connect_tools();
    void connect_views();

    // main_window_views.cpp: what stands around the vessels, what is measured, how it looks.
    void connect_context();
    void connect_measuring();
    void follow_measuring();
    void remove_measurements();
    void tell_lost_diameters(std::size_t lost);
    void connect_themes();
    void connect_mouse_schemes();
    void connect_languages();
    void speak(const QString& code);

    // main_window_volume.cpp: the CT as a volume around the vessels.
    void build_volume(QWidget* parent);
    void connect_volume();
    void say_why_no_volume(const Failure& failure);
    void show_volume_bar();
    void show_volume_look();

    // main_window_slices.cpp: slices of the CT, and corrections.
    void build_slices(QWidget* parent);
    // A CT while its vessels are looked for; null: there will be none. Not beside a patient who is
    // shown meanwhile.
    void show_image(std::shared_ptr<const Volume> ct);
    void end_image();
    // Else says why not; of a review in these words.
    bool may_correct(const char* why_not_in_review);
    void show_corrections_with_slices();
    void warn_of_stroke_outside(const BrushStroke& stroke);
    void build_editing();

    // main_window_lessons.cpp: lessons, and recordings that are looked back on.
    void build_lessons();
    void build_lesson_editor();
    // Opens a lesson's own patient; whoever was shown before can be had back when it is left.
    void open_for_lesson(const OpenRequest& request);
    void show_whole_from_the_front();
    // Who is shown, where he can be opened again.
    std::optional<OpenRequest> patient_from_where() const;
    void offer_patient_from_before();
    // The vessels were corrected: these lessons do not fit them any more.
    void tell_unfit(const std::vector<ShelvedLesson>& lessons);
    // What a lesson does not allow cannot be chosen while it is played.
    void allow_tools();
    void wait_for_place();
    void end_waiting_for_place();
    void set_lesson_place(const SurfacePick& pick);
    void build_review();

    // main_window_files.cpp: what is opened and saved.
    std::optional<std::filesystem::path> which_case();
    void ask_for_case();
    // Of earlier runs: cases and edits, lessons and plays that were interrupted.
    void offer_unsaved_work();
    void offer_unsaved_lesson();
    void forget(const std::vector<std::filesystem::path>& interrupted);
    void open_unsaved_work();
    void ask_for_ct(bool folder);
    std::optional<std::filesystem::path> ask_for_recording();
    void ask_for_reconstruction();
    void ask_where_to_save_picture();
    void ask_where_to_archive();
    void save_table(const QString& name, const std::string& csv);
    void save_plots(bool picture);
    void ask_and_save_film(double end_s, const std::function<void(double at_s)>& go_to);
    void remember(const std::filesystem::path& path);
    void fail(const QString& doing, const Failure& failure);
    bool may_end_lesson();
    void show_jobs();
    // Runs what may fail and shows the failure.
    void attempt(const QString& doing, const std::function<void()>& task);

    // main_window_back_end.cpp: what makes the steps.
    void connect_back_ends();
    void say_of_back_end(const std::string& words);
    void choose_back_end(const std::string& name);
    void measure_dial();

    // main_window_play.cpp: what is shown and played with.
    void show_patient(LoadedPatient patient, bool corrected);
    void show_warnings(bool corrected);
    void tell_warnings();       // all that hold, above the view
    void dismiss_for_a_deed();  // what is said above the view, unless it is those
    void show_workspace();
    void show_title(const QString& patient);
    void show_caption(const QString& text);  // in the first view
    // Frames come when the simulation has one to show: nothing asks for them.
    void follow_simulation();
    void show_newest_frame();
    // The yellow balls of the lesson that is played or edited. True where they moved.
    bool show_marks();
    std::optional<Vec3> middle_of_chosen_branch() const;
    void keep_dial();  // in the case
    // The dial is measured while nobody plays and no job runs.
    void tell_dial_keeper();
    // A lesson has enough to look at.
    bool plays_freely() const;
    void follow(const Frame& frame);  // by the controls of the play
    // Within a quarter of a second, and then not again until something has changed.
    void show_figures_soon();
    void show_figures();
    void show_message_of(const FrameStatistics& statistics);
    // Why a hand's deed in the view did nothing: at the window's foot, and beside the pointer.
    void hint(const QString& text);
    void say_missed();
    void say_empty_grip(GripWatch::Seen seen);
    void colour_by_segments(const std::vector<std::uint8_t>& of_branches);
    void show_hover(const SurfacePick& pick);
    void light_up(const TreePoint& under_mouse);
    // The slices' crosshair, to a vertex of the body at rest; -1: nowhere.
    void lead_crosshair_to(int vertex);
    void inject(const SurfacePick& pick);
    void tear(MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke);
    void picture_shown(const PictureTime& time);
    void post(Command command);
    void set_mouse_mode(MouseMode mode);
    void back_to_pulling();
    void take_tool(const std::string& kind);
    // In place of the simulation that runs; null: one of free play.
    void use(std::unique_ptr<Simulation> simulation);
    void match_anatomy();

    // main_window_reports.cpp: the report of a play.
    void write_report(const std::filesystem::path& recording, const std::string& lesson);
    void write_report_into(const std::filesystem::path& chosen,
                           const std::filesystem::path& recording, const std::string& lesson);
    void offer_report(const std::filesystem::path& folder);
    void take_report_message_away();

    // main_window_recording.cpp: a free play that is recorded.
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
    LessonEditor* lesson_editor_ = nullptr;  // null until then
    std::unique_ptr<DraftSlot> draft_slot_;  // likewise
    ReviewDock* review_ = nullptr;
    std::unique_ptr<StatusLine> status_;
    QTimer* figures_timer_ = nullptr;
    std::atomic<bool> frame_waits_ = false;  // show_newest_frame() is on its way
    std::optional<LoadedPatient> patient_;
    std::unique_ptr<PlayRecorder> recorder_;
    std::filesystem::path told_folder_;  // of the case, as the lesson editor knows it
    int hovered_vertex_ = -1;            // of the frame
    int chosen_branch_ = -1;             // in the table
    double picture_ms_ = 0.0;
    std::string last_message_;
    std::vector<std::string> warnings_;  // of the patient, that hold
    QString warnings_text_;              // as they were told last
    std::uint64_t warnings_origin_ = 0;  // of the workspace, whose warnings they are
    QString report_program_;
    QString report_message_;  // that says where the last report lies
    QString unfit_message_;   // that names lessons which fit no more
    QString place_message_;   // that asks for a place of a lesson
    std::function<void()> first_picture_;
    std::function<void(const std::optional<OpenRequest>&)> begin_anew_;
    bool begins_anew_ = false;  // once it has closed
    // Who was shown before a lesson brought its own patient.
    std::optional<OpenRequest> before_lesson_;
    std::optional<std::vector<LessonTool>> allowed_tools_;  // of the lesson that is played
    bool slices_for_image_ = false;  // they came by themselves, and go when the patient is there
    bool may_close_ = false;
    std::function<bool(const std::string& lesson)> end_lesson_;  // asks; see Questions
    bool in_close_event_ = false;
    std::unique_ptr<PatientKeeper> keeper_;
    std::unique_ptr<Recovery> recovery_;
    std::unique_ptr<CaseEditing> editing_;
    std::unique_ptr<DialKeeper> dial_;
    std::unique_ptr<LiverKeeper> liver_;
    std::unique_ptr<FitKeeper> fits_;
    VolumeLook volume_look_;
    std::unique_ptr<VolumeKeeper> volume_;
    std::unique_ptr<ViewRuler> ruler_;
};

}  // namespace hepatica
