// SPDX-License-Identifier: GPL-3.0-or-later
// The window: the patient in the middle (never floating), panels beside, figures below. It opens
// patients in the background, shows the newest frame, and sends what the user does as commands.
#pragma once

#include <QMainWindow>
#include <functional>
#include <memory>
#include <optional>

#include "ui/actions.h"
#include "ui/background_job.h"
#include "ui/mouse_tool.h"
#include "ui/patient_loader.h"
#include "ui/settings.h"

class QDockWidget;
class QMenu;
class QTimer;

namespace hepatica {

class CaseEditing;
class EditPanel;
class InjectPanel;
class MessageBar;
class PlotPanel;
class ProgressStrip;
class QualityPanel;
class StatusLine;
class VtkWidget;
class Welcome;

class MainWindow : public QMainWindow {
  public:
    // How patients come and go, all on the worker thread: load_patient() and write_case() in the
    // program, whatever a test needs in a test.
    struct Patients {
        std::function<LoadedPatient(const OpenRequest&, Job&)> load;
        std::function<void(const std::filesystem::path& folder, const PatientCase&)> save;
        // Of one that was corrected.
        std::function<LoadedPatient(std::shared_ptr<const PatientCase>, Job&)> play_on = play;
    };

    MainWindow(Settings& settings, Patients patients);
    ~MainWindow() override;

    // Starts to open a patient; one that is being opened is cancelled first. Returns at once.
    void open(const OpenRequest& request);
    void open(const QString& path);
    void cancel_job();
    bool busy() const { return job_ != nullptr; }

    bool has_patient() const { return patient_.has_value(); }
    // The newest frame that the view has taken over; only while there is a patient.
    const Frame& frame() const { return patient_->simulation->frame(); }
    VtkWidget& view() { return *view_; }
    MessageBar& messages() { return *messages_; }
    Actions& actions() { return *actions_; }

    // Writes what the view shows. Throws InputError where the file cannot be written.
    void save_picture(const QString& file);
    // Starts to write the patient that is shown; failures appear above the view.
    void save_case(const QString& folder);

    // Called once, when the first frame has been painted.
    void on_first_picture(std::function<void()> callback) { first_picture_ = std::move(callback); }

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void build_view();
    void build_panels();
    void build_tool_bar();
    void connect_files();
    void connect_play();
    void connect_views();
    void fill_recent_files();
    void show_cheat_sheet();
    void show_patient(LoadedPatient patient);
    void show_play(LoadedPatient patient);
    void rebuild(std::vector<TreeEdit> edits);
    void show_newest_frame();
    void show_figures();
    void show_hover(const SurfacePick& pick);
    void inject(const SurfacePick& pick);
    void plot_injection(const TreePoint& tip, const InjectDrug& injection);
    void save_plots(bool picture);
    void picture_painted(double ms);
    void post(Command command);
    void set_mouse_mode(MouseMode mode);
    void ask_for_ct(bool folder);
    void ask_where_to_save();
    void start_job(const QString& title, BackgroundJob::Work work);
    // Runs what may fail and shows the failure.
    void attempt(const std::function<void()>& task);

    Settings& settings_;
    Patients patients_;
    std::unique_ptr<Actions> actions_;
    VtkWidget* view_ = nullptr;
    Welcome* welcome_ = nullptr;
    MessageBar* messages_ = nullptr;
    ProgressStrip* progress_ = nullptr;
    InjectPanel* inject_ = nullptr;
    EditPanel* edit_panel_ = nullptr;
    std::unique_ptr<CaseEditing> editing_;
    QualityPanel* quality_ = nullptr;
    PlotPanel* plots_ = nullptr;
    QDockWidget* plots_dock_ = nullptr;
    QMenu* recent_menu_ = nullptr;
    std::unique_ptr<StatusLine> status_;
    QTimer* frame_timer_ = nullptr;
    QTimer* figures_timer_ = nullptr;
    std::optional<LoadedPatient> patient_;
    int hovered_segment_ = -1;
    double picture_ms_ = 0.0;
    std::string last_message_;
    std::function<void()> first_picture_;
    std::unique_ptr<BackgroundJob> job_;       // opens or saves
    std::unique_ptr<BackgroundJob> plot_job_;  // computes the curves of the last injection
};

}  // namespace hepatica
