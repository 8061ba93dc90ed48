// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollArea>
#include <QStyle>
#include <QTextBrowser>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "ui/case_editing.h"
#include "ui/edit_panel.h"
#include "ui/inject_panel.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/plot_panel.h"
#include "ui/progress_strip.h"
#include "ui/quality_panel.h"
#include "ui/status_line.h"
#include "ui/vessel_flow.h"
#include "ui/vtk_widget.h"
#include "ui/welcome.h"

namespace hepatica {
namespace {

constexpr std::array<std::pair<ActionId, ViewDirection>, 6> views{{
    {ActionId::view_anterior, ViewDirection::anterior},
    {ActionId::view_posterior, ViewDirection::posterior},
    {ActionId::view_left, ViewDirection::left},
    {ActionId::view_right, ViewDirection::right},
    {ActionId::view_superior, ViewDirection::superior},
    {ActionId::view_inferior, ViewDirection::inferior},
}};

QDockWidget* make_dock(QMainWindow& window, const QString& title, QWidget* content) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(title);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    auto* scroll = new QScrollArea(dock);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    const int bar = scroll->style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, scroll);
    scroll->setMinimumWidth(std::max(290, content->minimumSizeHint().width() + bar));
    dock->setWidget(scroll);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
}

}  // namespace

MainWindow::MainWindow(Settings& settings, Patients patients)
    : settings_(settings), patients_(std::move(patients)) {
    setWindowTitle("Hepatica");
    setAcceptDrops(true);
    resize(1280, 820);
    actions_ = std::make_unique<Actions>(*this, *menuBar());
    status_ = std::make_unique<StatusLine>(*statusBar());
    build_view();
    build_panels();
    build_tool_bar();
    connect_files();
    connect_play();
    connect_views();
    actions_->set_patient_shown(false);
    restoreGeometry(settings_.window_geometry());
    restoreState(settings_.window_layout());

    frame_timer_ = new QTimer(this);
    frame_timer_->setTimerType(Qt::PreciseTimer);
    connect(frame_timer_, &QTimer::timeout, this, [this] { show_newest_frame(); });
    figures_timer_ = new QTimer(this);
    connect(figures_timer_, &QTimer::timeout, this, [this] { show_figures(); });
    figures_timer_->start(250);
}

MainWindow::~MainWindow() = default;

void MainWindow::build_view() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    messages_ = new MessageBar(centre);
    progress_ = new ProgressStrip([this] { cancel_job(); }, centre);
    view_ =
        new VtkWidget({[this](Command command) { post(std::move(command)); },
                       [this](const SurfacePick& pick) { inject(pick); },
                       [this](const SurfacePick& pick) { show_hover(pick); },
                       [this](const SurfacePick& pick) {
                           if (patient_)
                               editing_->click(patient_->anatomy.tree_point(pick.nearest_vertex));
                       },
                       [this](int bridge) { editing_->accept(bridge); }},
                      centre);
    view_->on_painted([this](double ms) { picture_painted(ms); });
    column->addWidget(messages_);
    column->addWidget(view_, 1);
    column->addWidget(progress_);
    setCentralWidget(centre);
    welcome_ = new Welcome(*actions_, view_);
}

void MainWindow::build_panels() {
    inject_ = new InjectPanel([this](Command command) { post(std::move(command)); });
    quality_ = new QualityPanel([this](Command command) { post(std::move(command)); });
    make_dock(*this, "Injection", inject_);
    make_dock(*this, "Simulation", quality_);
    edit_panel_ = new EditPanel;
    QDockWidget* edit_dock = make_dock(*this, "Corrections", edit_panel_);
    tabifyDockWidget(findChild<QDockWidget*>("Injection"), edit_dock);
    findChild<QDockWidget*>("Injection")->raise();
    editing_ = std::make_unique<CaseEditing>(
        *edit_panel_, CaseEditing::Callbacks{
                          [this](std::vector<TreeEdit> edits) { rebuild(std::move(edits)); },
                          [this](std::vector<BridgeView> bridges) {
                              view_->scene().set_bridges(std::move(bridges));
                              view_->draw_again();
                          },
                          [this](const QString& text) { statusBar()->showMessage(text, 8000); }});
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    plots_ = new PlotPanel;
    plots_->on_save = [this](bool picture) { save_plots(picture); };
    plots_dock_ = new QDockWidget("Curves", this);
    plots_dock_->setObjectName("Curves");
    plots_dock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    plots_dock_->setWidget(plots_);
    addDockWidget(Qt::BottomDockWidgetArea, plots_dock_);
    plots_dock_->hide();
}

void MainWindow::build_tool_bar() {
    auto* bar = new QToolBar("Tools", this);
    bar->setObjectName("Tools");
    bar->setMovable(false);
    auto* modes = new QActionGroup(this);
    for (const ActionId id : {ActionId::pull_mode, ActionId::inject_mode, ActionId::edit_mode}) {
        modes->addAction(&(*actions_)[id]);
        bar->addAction(&(*actions_)[id]);
    }
    bar->addSeparator();
    bar->addAction(&(*actions_)[ActionId::play_pause]);
    bar->addAction(&(*actions_)[ActionId::reset]);
    bar->addSeparator();
    for (const auto& [id, direction] : views) bar->addAction(&(*actions_)[id]);
    addToolBar(bar);
}

void MainWindow::connect_files() {
    actions_->on(ActionId::open_case, [this] {
        const QString folder = QFileDialog::getExistingDirectory(
            this, "Open case (a folder NAME.hep)", settings_.last_folder());
        if (!folder.isEmpty()) open(folder);
    });
    actions_->on(ActionId::open_ct_folder, [this] { ask_for_ct(true); });
    actions_->on(ActionId::open_ct_file, [this] { ask_for_ct(false); });
    actions_->on(ActionId::built_in, [this] { open(OpenRequest{true, {}}); });
    actions_->on(ActionId::reconstruct, [this] {
        PatientWizard wizard(settings_.last_folder(), this);
        if (wizard.exec() == QDialog::Accepted) open(OpenRequest{false, wizard.options()});
    });
    actions_->on(ActionId::save_case, [this] { ask_where_to_save(); });
    actions_->on(ActionId::save_picture, [this] {
        const QString file = QFileDialog::getSaveFileName(
            this, "Save picture", settings_.last_folder() + "/hepatica.png", "PNG (*.png)");
        if (!file.isEmpty()) attempt([&] { save_picture(file); });
    });
    actions_->on(ActionId::quit, [this] { close(); });
    recent_menu_ = new QMenu("Open &recent", this);
    connect(recent_menu_, &QMenu::aboutToShow, this, [this] { fill_recent_files(); });
    QMenu* file_menu = menuBar()->actions().front()->menu();
    file_menu->insertMenu(&(*actions_)[ActionId::built_in], recent_menu_);
}

void MainWindow::connect_play() {
    actions_->on(ActionId::pull_mode, [this] { set_mouse_mode(MouseMode::pull); });
    actions_->on(ActionId::inject_mode, [this] { set_mouse_mode(MouseMode::inject); });
    actions_->on(ActionId::edit_mode, [this] { set_mouse_mode(MouseMode::edit); });
    actions_->on(ActionId::undo_edit, [this] { editing_->undo(); });
    actions_->on(ActionId::redo_edit, [this] { editing_->redo(); });
    (*actions_)[ActionId::pull_mode].setChecked(true);
    actions_->on(ActionId::play_pause, [this] { inject_->toggle_playing(); });
    actions_->on(ActionId::remove_drug, [this] { post(RemoveDrug{}); });
    actions_->on(ActionId::pause_simulation,
                 [this] { post(SetPaused{(*actions_)[ActionId::pause_simulation].isChecked()}); });
    actions_->on(ActionId::reset, [this] { post(ResetWorld{}); });
    actions_->on(ActionId::restore, [this] { post(RestoreSnapshot{}); });
}

void MainWindow::connect_views() {
    for (const auto& [id, direction] : views) {
        actions_->on(id, [this, direction] {
            view_->scene().look_from(direction);
            view_->draw_again();
        });
    }
    QAction& annotations = (*actions_)[ActionId::toggle_annotations];
    annotations.setChecked(true);
    actions_->on(ActionId::toggle_annotations, [this, &annotations] {
        view_->scene().set_annotations_visible(annotations.isChecked());
        view_->draw_again();
    });
    QAction& plots = (*actions_)[ActionId::toggle_plots];
    actions_->on(ActionId::toggle_plots,
                 [this, &plots] { plots_dock_->setVisible(plots.isChecked()); });
    connect(plots_dock_, &QDockWidget::visibilityChanged, &plots, &QAction::setChecked);
    QAction& panels = (*actions_)[ActionId::toggle_panels];
    panels.setChecked(true);
    actions_->on(ActionId::toggle_panels, [this, &panels] {
        for (QDockWidget* dock : findChildren<QDockWidget*>()) {
            if (dock != plots_dock_) dock->setVisible(panels.isChecked());
        }
    });
    actions_->on(ActionId::cheat_sheet, [this] { show_cheat_sheet(); });
    actions_->on(ActionId::about, [this] {
        QMessageBox::about(this, "About Hepatica",
                           "<b>Hepatica " HEPATICA_VERSION
                           "</b><p>Practise on a patient's own "
                           "liver vessels.</p><p>Renderer: " +
                               QString::fromStdString(view_->renderer_name()).toHtmlEscaped() +
                               "</p><p>Licence: GPL-3.0-or-later. Not a medical device.</p>");
    });
}

void MainWindow::show_cheat_sheet() {
    auto* sheet = new QDialog(this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setWindowTitle("Keys and mouse");
    sheet->resize(620, 640);
    auto* text = new QTextBrowser(sheet);
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(Actions::cheat_sheet());
    auto* column = new QVBoxLayout(sheet);
    column->addWidget(text);
    sheet->show();
}

void MainWindow::fill_recent_files() {
    recent_menu_->clear();
    for (const QString& path : settings_.recent_files()) {
        recent_menu_->addAction(path, this, [this, path] { open(path); });
    }
    recent_menu_->addSeparator();
    recent_menu_->addAction("Clear", this, [this] { settings_.clear_recent_files(); });
}

void MainWindow::open(const QString& path) {
    settings_.set_last_folder(QFileInfo(path).absolutePath());
    OpenRequest request;
    request.reconstruct.ct = to_path(path);
    open(request);
}

void MainWindow::open(const OpenRequest& request) {
    const QString path = to_text(request.reconstruct.ct);
    const QString title = request.built_in ? QString("Opening the built-in patient")
                                           : "Opening " + QFileInfo(path).fileName();
    start_job(title, [this, request, path, load = patients_.load](Job& job) {
        // std::function wants to be copied, a loaded patient does not.
        auto loaded = std::make_shared<LoadedPatient>(load(request, job));
        return [this, loaded, path] {
            if (!path.isEmpty()) settings_.add_recent_file(path);
            show_patient(std::move(*loaded));
        };
    });
}

void MainWindow::start_job(const QString& title, BackgroundJob::Work work) {
    job_.reset();
    messages_->dismiss();
    progress_->start(title);
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this](const JobProgress& now) { progress_->update_progress(now); };
    callbacks.failed = [this](const Failure& failure) { messages_->show_failure(failure); };
    callbacks.cancelled = [this] { statusBar()->showMessage("Cancelled", 4000); };
    callbacks.ended = [this] {
        progress_->finish();
        editing_->job_ended();
        job_.reset();
    };
    job_ = std::make_unique<BackgroundJob>(std::move(work), std::move(callbacks));
}

void MainWindow::cancel_job() {
    if (!job_) return;
    progress_->say_cancelling();
    job_->cancel();
}

void MainWindow::show_patient(LoadedPatient patient) {
    view_->scene().show(Frame{});  // forgets the patient before: the camera finds the new one
    show_play(std::move(patient));
    editing_->show(patient_->patient, false);
    if (!patient_->warnings.empty()) {
        QStringList lines;
        for (const std::string& warning : patient_->warnings) {
            lines << QString::fromStdString(warning);
        }
        messages_->show_notice(lines.join("\n"));
    }
}

void MainWindow::rebuild(std::vector<TreeEdit> edits) {
    if (!patient_) return;
    start_job("Correcting the tree", [this, edits = std::move(edits), title = patient_->title,
                                      folder = patient_->folder, patient = patient_->patient,
                                      play_on = patients_.play_on](Job& job) {
        auto corrected = std::make_shared<const PatientCase>(with_edits(*patient, edits, job));
        auto loaded = std::make_shared<LoadedPatient>(play_on(std::move(corrected), job));
        loaded->title = title;
        loaded->folder = folder;
        return [this, loaded] {
            show_play(std::move(*loaded));
            editing_->show(patient_->patient, true);
        };
    });
}

void MainWindow::show_play(LoadedPatient patient) {
    plot_job_.reset();
    plots_->clear();
    patient_ = std::move(patient);
    hovered_segment_ = -1;
    welcome_->hide();
    setWindowTitle(QString::fromStdString(patient_->title) + "[*] - Hepatica");
    setWindowModified(!patient_->on_disk);
    SceneView& scene = view_->scene();
    scene.set_caption(patient_->title);
    scene.set_highlight({});
    scene.set_vertex_systems(patient_->anatomy.vertex_systems());
    actions_->set_patient_shown(true);
    (*actions_)[ActionId::save_case].setEnabled(true);
    (*actions_)[ActionId::pause_simulation].setChecked(false);
    quality_->post_choices();
    inject_->post_choices();
    frame_timer_->start(16);
}

void MainWindow::show_newest_frame() {
    if (!patient_ || !patient_->simulation->update_frame()) return;
    view_->show_frame(patient_->simulation->frame());
}

void MainWindow::show_figures() {
    if (picture_ms_ > 0.0) status_->show_picture_time(picture_ms_);
    if (!patient_) return status_->clear_statistics();
    const Frame& frame = patient_->simulation->frame();
    status_->show_statistics(frame.statistics);
    quality_->show_statistics(frame.statistics);
    inject_->show_drug(frame.drug);
    const bool injected = frame.drug.arrival_s != nullptr;
    plots_->set_time(injected ? std::optional(frame.drug.time_s) : std::nullopt);
    if (frame.statistics.message != last_message_) {
        last_message_ = frame.statistics.message;
        const QString text = QString::fromStdString(last_message_);
        // What stops the play stands above the view; what merely happens passes below it.
        if (frame.statistics.paused && !text.isEmpty()) {
            messages_->show_notice(text);
        } else {
            statusBar()->showMessage(text, 4000);
        }
    }
}

void MainWindow::show_hover(const SurfacePick& pick) {
    if (!patient_) return;
    const TreePoint point = patient_->anatomy.tree_point(pick.nearest_vertex);
    if (point.segment == hovered_segment_) return;
    hovered_segment_ = point.segment;
    inject_->show_hover(
        QString::fromStdString(patient_->anatomy.describe(point, patient_->flow_shares)));
    view_->scene().set_highlight(patient_->anatomy.downstream_of(point));
    view_->draw_again();
}

void MainWindow::inject(const SurfacePick& pick) {
    if (!patient_) return;
    const InjectDrug injection = inject_->injection_at(pick.position_mm);
    post(injection);
    plot_injection(patient_->anatomy.tree_point(pick.nearest_vertex), injection);
}

void MainWindow::plot_injection(const TreePoint& tip, const InjectDrug& injection) {
    if (tip.segment < 0) return;
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [](const JobProgress&) {};
    callbacks.failed = [this](const Failure& failure) { messages_->show_failure(failure); };
    callbacks.cancelled = [] {};
    callbacks.ended = [this] { plot_job_.reset(); };
    plot_job_ = std::make_unique<BackgroundJob>(
        [this, tip, injection, patient = patient_->patient](Job& job) -> std::function<void()> {
            const auto curves = injection_curves(patient->tree, tip, injection, job);
            return [this, curves] {
                plots_->set_charts(curves.pressure, curves.delivery);
                plots_dock_->show();
            };
        },
        std::move(callbacks));
}

void MainWindow::picture_painted(double ms) {
    if (picture_ms_ == 0.0) status_->show_renderer(view_->renderer_name());
    picture_ms_ = ms;
    if (patient_) patient_->simulation->set_drawing_ms(ms);
    if (!first_picture_) return;
    // The frame is on the screen once the event loop comes round again.
    QTimer::singleShot(0, this, std::exchange(first_picture_, nullptr));
}

void MainWindow::post(Command command) {
    if (patient_) patient_->simulation->post(std::move(command));
}

void MainWindow::set_mouse_mode(MouseMode mode) {
    view_->mouse().set_mode(mode);
    view_->setCursor(mode == MouseMode::pull ? Qt::ArrowCursor : Qt::CrossCursor);
    if (mode == MouseMode::edit) findChild<QDockWidget*>("Corrections")->raise();
    if (mode == MouseMode::inject) findChild<QDockWidget*>("Injection")->raise();
    statusBar()->showMessage(mode == MouseMode::pull     ? "Drag a vessel to pull it"
                             : mode == MouseMode::inject ? "Click on a vessel to inject there"
                                                         : "Click on a vessel to correct the tree",
                             6000);
}

void MainWindow::attempt(const std::function<void()>& task) {
    try {
        task();
    } catch (...) {
        messages_->show_failure(failure_of(std::current_exception()));
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    settings_.set_window(saveGeometry(), saveState());
    frame_timer_->stop();
    job_.reset();
    plot_job_.reset();
    patient_.reset();
    QMainWindow::closeEvent(event);
}

}  // namespace hepatica
