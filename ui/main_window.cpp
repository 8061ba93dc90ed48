// SPDX-License-Identifier: GPL-3.0-or-later
// Places the window's panels and connects them.
#include "ui/main_window.h"

#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "core/scene/vessel_direction.h"
#include "ui/branch_dock.h"
#include "ui/case_editing.h"
#include "ui/curves_dock.h"
#include "ui/dial_keeper.h"
#include "ui/edit_panel.h"
#include "ui/elided_status_bar.h"
#include "ui/enter_key.h"
#include "ui/fit_keeper.h"
#include "ui/focus_of_view.h"
#include "ui/help_dialogs.h"
#include "ui/inject_panel.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/draft_slot.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/library_dialog.h"
#include "ui/liver_keeper.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/play_recorder.h"
#include "ui/play_sounds.h"
#include "ui/plot_panel.h"
#include "ui/popup_guard.h"
#include "ui/progress_strip.h"
#include "ui/quality_panel.h"
#include "ui/questions.h"
#include "ui/recent_menu.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"
#include "ui/status_line.h"
#include "ui/tool_panel.h"
#include "ui/view_ruler.h"
#include "ui/volume_bar.h"
#include "ui/volume_keeper.h"
#include "ui/vtk_widget.h"
#include "ui/welcome.h"
#include "ui/wheel_guard.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr double turn_rad = std::numbers::pi / 12.0;  // per key press

constexpr std::array<std::pair<ActionId, const char*>, 4> tool_actions{{
    {ActionId::sphere_tool, "sphere"},
    {ActionId::capsule_tool, "capsule"},
    {ActionId::forceps_tool, "forceps"},
    {ActionId::hook_tool, "hook"},
}};

constexpr std::array<std::pair<ActionId, ViewDirection>, 6> views{{
    {ActionId::view_anterior, ViewDirection::anterior},
    {ActionId::view_posterior, ViewDirection::posterior},
    {ActionId::view_left, ViewDirection::left},
    {ActionId::view_right, ViewDirection::right},
    {ActionId::view_superior, ViewDirection::superior},
    {ActionId::view_inferior, ViewDirection::inferior},
}};

QDockWidget* make_dock(QMainWindow& window, const char* name, QWidget* content) {
    auto* dock = new QDockWidget(Words::tr(name), &window);
    dock->setObjectName(name);
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

MainWindow::MainWindow(Settings& settings, Patients patients,
                       std::optional<PatientKeeper::Questions> questions)
    : settings_(settings), back_ends_(patients.back_ends) {
    new WheelGuard(this);  // owned by the window
    new PopupGuard(this);
    new EnterKey(this);
    show_title({});
    setAcceptDrops(true);
    resize_on_screen(*this, {1280, 820});
    actions_ = std::make_unique<Actions>(*this, *menuBar());
    auto* foot = new ElidedStatusBar(this);
    setStatusBar(foot);
    status_ = std::make_unique<StatusLine>(*foot);
    build_view();
    build_panels();
    build_tool_bar();
    if (!questions) questions = questions_in_dialogs(*this, settings_);
    end_lesson_ = questions->end_lesson;
    end_play_ = questions->end_play;
    copy_of_unsaved_ = questions->copy_of_unsaved;
    make_keeper(std::move(patients), std::move(*questions));
    dial_ = std::make_unique<DialKeeper>([this](const QualityDial& dial) {
        if (patient_) patient_->simulation->use_dial(dial);
        kept_play_.use_dial(dial, back_ends_->chosen());
    });
    connect_files();
    connect_play();
    connect_back_ends();
    connect_recording();
    connect_tools();
    connect_views();
    connect_panels();
    connect_help();
    connect_sounds();
    connect_context();
    connect_volume();
    connect_measuring();
    connect_themes();
    connect_mouse_schemes();
    connect_units();
    connect_languages();
    actions_->set_patient_shown(false);
    restoreGeometry(settings_.window_geometry());
    restore_unframed(*this, settings_.unframed_window());
    restoreState(settings_.window_layout());
    resize_on_screen(*this, size());
    review_->hide();  // there is nothing to review yet
    lessons_->hide();
    offer_unsaved_work();
    offer_unsaved_lesson();

    figures_timer_ = new QTimer(this);
    figures_timer_->setSingleShot(true);
    figures_timer_->setInterval(250);
    connect(figures_timer_, &QTimer::timeout, this, [this] { show_figures(); });
}

// The review refers to the second view, so it ends first.
MainWindow::~MainWindow() {
    review_->end();
    back_ends_->on_words({});
}

void MainWindow::build_view() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    view_ = new VtkWidget(
        {[this](Command command) { post(std::move(command)); },
         [this](const SurfacePick& pick) { inject(pick); },
         [this](const SurfacePick& pick) { show_hover(pick); },
         [this](const SurfacePick& pick) {
             if (!patient_) return;
             if (view_->mouse().mode() == MouseMode::place) return set_lesson_place(pick);
             if (view_->mouse().mode() == MouseMode::measure)
                 return ruler_->click(pick, view_->scene().axes());
             editing_->click(patient_->anatomy.tree_point(frame().origin_of(pick.nearest_vertex)));
         },
         [this](int view) { editing_->click_drawn(view); },
         [this](const SurfacePick& pick) {
             if (!patient_) return Vec3(Vec3::Zero());
             return vessel_direction(
                 patient_->patient->tree,
                 patient_->anatomy.tree_point(frame().origin_of(pick.nearest_vertex)));
         },
         [this](MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke) {
             tear(mode, stroke);
         },
         [this] { say_missed(); },
         [this](const SurfacePick& pick) {
             if (patient_) lead_crosshair_to(frame().origin_of(pick.nearest_vertex));
         }},
        centre);
    view_->setObjectName("view");
    give_focus_back_to(*view_);
    status_->on_warnings = [this] { tell_warnings(); };
    view_->on_picture([this](const PictureTime& time) { picture_shown(time); });
    build_volume(centre);
    column->addWidget(volume_bar_);
    build_slices(centre);
    messages_ = new MessageBar(&view_layout_->pictures());
    messages_->fold_when_used(*view_);
    auto* views = new QWidget(centre);
    auto* row = new QHBoxLayout(views);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    second_view_ = new SecondView(
        *view_, [this](VtkWidget& view) { show_as_first(view); }, views);
    row->addWidget(view_layout_, 1);
    row->addWidget(second_view_, 1);
    column->addWidget(views, 1);
    // Over both, so that of two pictures that are compared it covers as much.
    progress_ = new ProgressStrip([this] { cancel_job(); }, views);
    setCentralWidget(centre);
    welcome_ = new Welcome(
        *actions_, [this] { lessons_->show_chosen_course(); }, view_);
    show_welcome(true);
    log_ = new MessageLog(this);
    messages_->on_branch = log_->on_branch = [this](int branch) { branches_->show_branch(branch); };
    const auto keep_clear = [this] {
        view_layout_->keep_clear(messages_->covered(), progress_->covered());
        second_view_->keep_clear(progress_->covered());
        welcome_->keep_clear(messages_->covered());
    };
    messages_->on_cover = progress_->on_cover = keep_clear;
}

void MainWindow::build_panels() {
    inject_ = new InjectPanel([this](Command command) { post(std::move(command)); });
    quality_ = new QualityPanel([this](Command command) { post(std::move(command)); });
    make_dock(*this, Words::id("Injection"), inject_);
    make_dock(*this, Words::id("Simulation"), quality_);
    edit_panel_ = new EditPanel;
    // Whoever chooses what a click corrects wants to click.
    connect(edit_panel_->findChild<QComboBox*>("EditTool"), &QComboBox::activated, this, [this] {
        QAction& edit = (*actions_)[ActionId::edit_mode];
        if (edit.isEnabled() && !edit.isChecked()) edit.trigger();
    });
    QDockWidget* edit_dock = make_dock(*this, Words::id("Corrections"), edit_panel_);
    tabifyDockWidget(findChild<QDockWidget*>("Injection"), edit_dock);
    tool_panel_ =
        new ToolPanel({[this](const ToolSize& size) { view_->mouse().hand().set_size(size); },
                       [this](const UseTear& tear) { post(tear); },
                       [this](const UseContact& contact) { post(contact); },
                       [this](bool shown) {
                           view_->scene().set_warnings_visible(shown);
                           view_->draw_again();
                           second_view_->take_after_first();
                       },
                       [this](const UseContact& contact) { settings_.set_contact(contact); }});
    if (const auto contact = settings_.contact()) tool_panel_->set_wanted_contact(*contact);
    view_->scene().set_warnings_visible(tool_panel_->shows_warnings());
    tabifyDockWidget(edit_dock, make_dock(*this, Words::id("Tool"), tool_panel_));
    findChild<QDockWidget*>("Injection")->raise();
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    curves_ = new CurvesDock([this](const Failure& failure) { fail(Words::tr("Curves"), failure); },
                             this);
    curves_->plots().on_save = [this](bool picture) { save_plots(picture); };
    addDockWidget(Qt::BottomDockWidgetArea, curves_);
    curves_->hide();
    const auto show_units = [this](FlowUnits units) {
        tool_panel_->set_units(units);
        curves_->plots().set_units(units);
        if (lessons_ != nullptr) lessons_->set_units(units);
    };
    inject_->on_units = [this, show_units](FlowUnits units) {
        settings_.set_flow_units(name_of(units));
        show_units(units);
        show_figures_soon();
    };
    inject_->set_units(flow_units_named(settings_.flow_units()));
    show_units(flow_units_named(settings_.flow_units()));
    build_branches();
    build_fits();
    build_lessons();
    build_review();
}

void MainWindow::build_branches() {
    BranchDock::Callbacks callbacks;
    callbacks.choose = [this](const BranchRow& row) {
        chosen_branch_.choose(row.branch, patient_->patient);
        light_up(TreePoint{});
        view_layout_->slices().set_crosshair(row.middle_mm);
    };
    callbacks.colour = [this](const std::vector<std::uint8_t>& of_branches) {
        colour_by_segments(of_branches);
    };
    callbacks.save = [this](const std::string& csv) {
        save_table(*this, proposed_file("branches.csv"), csv);
    };
    callbacks.failed = [this](const Failure& failure) {
        fail(Words::tr("Liver segments"), failure);
    };
    branches_ = new BranchDock(std::move(callbacks), this);
    // Stacked: side by side they would be wider than a small screen.
    tabifyDockWidget(curves_, branches_);
    branches_->hide();
}

void MainWindow::make_keeper(Patients patients, PatientKeeper::Questions questions) {
    const QString kept = settings_.recovery_folder();
    recovery_ = std::make_unique<Recovery>(
        to_path(kept), kept.isEmpty() ? Recovery::Write() : patients.keep,
        [this](const Failure& failure) {
            fail(Words::tr("Keeping a copy of unsaved work"), failure);
        });
    PatientKeeper::Screen screen;
    screen.show = [this](LoadedPatient patient, bool corrected) {
        show_patient(std::move(patient), corrected);
    };
    screen.changed = [this] { show_workspace(); };
    screen.failed = [this](const std::string& doing, const Failure& failure) {
        fail(QString::fromStdString(doing), failure);
    };
    screen.say = [this](const std::string& text) {
        statusBar()->showMessage(QString::fromStdString(text), 6000);
    };
    screen.remember = [this](const std::filesystem::path& path) { remember(path); };
    screen.case_written = [this](const std::filesystem::path& place) {
        if (place == workspace().folder()) dial_->case_was_written();
        library_->refresh();
    };
    screen.kept_play = [this] { return kept_play_.kept(); };
    screen.remake_painted = [this] { view_layout_->remake_painted(); };
    screen.image_read = [this](std::shared_ptr<const Volume> ct) { show_image(std::move(ct)); };
    screen.not_opened = [this] {
        show_image(nullptr);
        lessons_->patient_not_shown();
        before_lesson_.reset();
        if (lesson_editor_ && !lessons_->playing()) lesson_editor_->back_from_trying();
        review_->patient_not_shown();
    };
    keeper_ = std::make_unique<PatientKeeper>(
        std::move(patients), std::move(questions), std::move(screen),
        JobQueue::Watcher{
            [this](const std::string& title) { progress_->start(QString::fromStdString(title)); },
            [this](const JobProgress& now) { progress_->update_progress(now); },
            [this] { show_jobs(); }});
    build_editing();
}

void MainWindow::build_tool_bar() {
    auto* bar = new QToolBar(Words::tr("Tools"), this);
    bar->setObjectName("Tools");
    bar->setMovable(false);
    auto* modes = new QActionGroup(this);
    for (const ActionId id : {ActionId::pull_mode, ActionId::inject_mode, ActionId::edit_mode}) {
        modes->addAction(&(*actions_)[id]);
        bar->addAction(&(*actions_)[id]);
    }
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (const auto& [id, kind] : tool_actions) {
        modes->addAction(&(*actions_)[id]);
        bar->addAction(&(*actions_)[id]);
        // Icons alone, because the bar has little room.
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(&(*actions_)[id])))
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
    for (const ActionId id : {ActionId::cut_mode, ActionId::weaken_mode}) {
        modes->addAction(&(*actions_)[id]);
        bar->addAction(&(*actions_)[id]);
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(&(*actions_)[id])))
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
    for (const ActionId id : measuring_actions) modes->addAction(&(*actions_)[id]);
    add_measure_button(*actions_, *bar);
    bar->addSeparator();
    bar->addAction(&(*actions_)[ActionId::play_pause]);
    bar->addAction(&(*actions_)[ActionId::reset]);
    bar->addSeparator();
    for (const auto& [id, direction] : views) bar->addAction(&(*actions_)[id]);
    // Short texts, so that all six views fit on a small screen.
    (*actions_)[ActionId::edit_mode].setIconText(Words::tr("Edit"));
    (*actions_)[ActionId::play_pause].setIconText(Words::tr("Run"));
    (*actions_)[ActionId::reset].setIconText(Words::tr("Reset"));
    addToolBar(bar);
    bar->findChild<QWidget*>("qt_toolbar_ext_button")->setAccessibleName(Words::tr("More tools"));
}

void MainWindow::connect_files() {
    library_ = new LibraryDialog(
        settings_,
        {[this](const QString& path) { open(path); },
         [this](const QString& doing, const Failure& failure) { fail(doing, failure); },
         [this](const ShelvedLesson& lesson, const QString& place) {
             lessons_->start_on(lesson.file.string(), place);
         },
         [this](const std::filesystem::path& place, const LibraryDialog::Copy& copy) {
             copy_case(place, copy);
         }},
        this);
    actions_->on(ActionId::open_library, [this] { library_->open_library(); });
    actions_->on(ActionId::open_case, [this] { ask_for_case(); });
    actions_->on(ActionId::open_ct_folder, [this] { ask_for_ct(true); });
    actions_->on(ActionId::open_ct_file, [this] { ask_for_ct(false); });
    connect_unsaved_work();
    actions_->on(ActionId::open_recording, [this] {
        if (const auto file = ask_for_recording()) review_->open(*file);
    });
    actions_->on(ActionId::built_in, [this] { open(OpenRequest{true, {}}); });
    actions_->on(ActionId::reconstruct, [this] { ask_for_reconstruction(); });
    actions_->on(ActionId::save_case, [this] { keeper_->save(); });
    actions_->on(ActionId::save_case_as, [this] { keeper_->ask_and_save(); });
    actions_->on(ActionId::archive_case, [this] { ask_where_to_archive(); });
    actions_->on(ActionId::save_picture, [this] { ask_where_to_save_picture(); });
    actions_->on(ActionId::quit, [this] { close(); });
    auto* recent = new RecentMenu(
        settings_,
        {[this](const QString& path) { open(path); },
         [this](const QString& path) {
             messages_->show_notice(Words::tr("%1 is not there any more; it was taken off "
                                              "the list of recent files.")
                                        .arg(path));
         }},
        this);
    QMenu* file_menu = menuBar()->actions().front()->menu();
    file_menu->insertMenu(&(*actions_)[ActionId::built_in], recent);
}

void MainWindow::connect_play() {
    actions_->on(ActionId::pull_mode, [this] { set_mouse_mode(MouseMode::pull); });
    actions_->on(ActionId::inject_mode, [this] { set_mouse_mode(MouseMode::inject); });
    actions_->on(ActionId::edit_mode, [this] { set_mouse_mode(MouseMode::edit); });
    actions_->on(ActionId::undo_edit, [this] { undo(); });
    actions_->on(ActionId::redo_edit, [this] { keeper_->redo(); });
    (*actions_)[ActionId::pull_mode].setChecked(true);
    actions_->on(ActionId::play_pause, [this] { inject_->toggle_playing(); });
    actions_->on(ActionId::remove_drug, [this] { post(RemoveDrug{}); });
    actions_->on(ActionId::pause_simulation, [this] {
        if (!patient_) return;
        post(SetPaused{!frame().statistics.paused});
        follow(frame());  // resets Qt's own check mark until a frame confirms it
    });
    actions_->on(ActionId::reset, [this] { post(ResetWorld{}); });
    actions_->on(ActionId::restore, [this] { post(RestoreSnapshot{}); });
}

void MainWindow::connect_tools() {
    for (const auto& [id, kind] : tool_actions)
        actions_->on(id, [this, kind = std::string(kind)] { take_tool(kind); });
    actions_->on(ActionId::cut_mode, [this] { set_mouse_mode(MouseMode::cut); });
    actions_->on(ActionId::weaken_mode, [this] { set_mouse_mode(MouseMode::weaken); });
    ToolHand& hand = view_->mouse().hand();
    hand.set_size(tool_panel_->size());
    hand.may_bring = [this] { return step_lets_clicks_bring(); };
    hand.on_empty_grip = [this](GripWatch::Seen seen) { say_empty_grip(seen); };
    actions_->on(ActionId::turn_tool, [&hand] { hand.turn(turn_rad); });
    actions_->on(ActionId::turn_tool_back, [&hand] { hand.turn(-turn_rad); });
    actions_->on(ActionId::close_or_open, [&hand] { hand.close_or_open(); });
    actions_->on(ActionId::put_tool_away, [this] {
        if (view_->mouse().holds()) {  // a vessel, or a line half drawn
            view_->let_go();
            return view_->draw_again();
        }
        const MouseMode mode = view_->mouse().mode();
        const bool draws = mode == MouseMode::cut || mode == MouseMode::weaken;
        if (draws || mode == MouseMode::measure || mode == MouseMode::place ||
            view_->mouse().hand().holds())
            back_to_pulling();
    });
}

void MainWindow::connect_views() {
    for (const auto& [id, direction] : views) {
        actions_->on(id, [this, direction] {
            view_->scene().look_from(direction);
            view_->draw_again();
        });
    }
    connect_picture_parts();
    QAction& slices = (*actions_)[ActionId::toggle_slices];
    actions_->on(ActionId::choose_threshold, [this, &slices] {
        if (!slices.isChecked()) slices.trigger();
        view_layout_->choose_threshold();
    });
    actions_->on(ActionId::toggle_slices, [this, &slices] {
        view_layout_->set_slices_visible(slices.isChecked());
        editing_->show_history();  // points that are not seen are not undone
    });
    actions_->on(ActionId::full_screen,
                 [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    keep_focus_in_sight(*this, *view_);
}

void MainWindow::connect_help() {
    actions_->on(ActionId::guide,
                 [this] { attempt(Words::tr("Guide"), [this] { show_guide(*this); }); });
    actions_->on(ActionId::cheat_sheet,
                 [this] { show_cheat_sheet(*this, settings_.mouse_scheme()); });
    actions_->on(ActionId::messages, [this] { log_->show(); });
    actions_->on(ActionId::about,
                 [this] { show_about(*this, QString::fromStdString(view_->renderer_name())); });
}

}  // namespace hepatica
