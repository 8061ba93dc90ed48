// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for the panels that are shown and hidden, the view's surroundings,
// measuring, and the look of window and view.
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/branch_dock.h"
#include "ui/core_words.h"
#include "ui/curves_dock.h"
#include "ui/inject_panel.h"
#include "ui/language.h"
#include "ui/lesson_dock.h"
#include "ui/liver_keeper.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"
#include "ui/theme.h"
#include "ui/tool_panel.h"
#include "ui/view_ruler.h"
#include "ui/vtk_widget.h"
#include "ui/welcome.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array theme_actions{ActionId::theme_dark, ActionId::theme_light,
                                   ActionId::theme_high_contrast};

// Shows a dock in front of those that share its place, or hides it.
void show_dock(QDockWidget& dock, bool visible) {
    dock.setVisible(visible);
    if (visible) dock.raise();
}

// An entry of a short list, whose key in the menu is its number: names have no letter to spare.
QString numbered(int number, const QString& name) {
    return QString("&%1  %2").arg(number).arg(name);
}

}  // namespace

// Behind the start page the view is empty: the keys go past it.
void MainWindow::show_welcome(bool visible) {
    welcome_->setVisible(visible);
    view_->setFocusPolicy(visible ? Qt::NoFocus : Qt::StrongFocus);
}

void MainWindow::connect_panels() {
    QAction& branches = (*actions_)[ActionId::toggle_branches];
    actions_->on(ActionId::toggle_branches,
                 [this, &branches] { show_dock(*branches_, branches.isChecked()); });
    connect(branches_, &QDockWidget::visibilityChanged, &branches, &QAction::setChecked);
    connect(branches_, &QDockWidget::visibilityChanged, this, [this] {
        if (patient_) light_up(TreePoint{});
    });
    QAction& plots = (*actions_)[ActionId::toggle_plots];
    curves_->set_comes_by_itself(settings_.curves_come());
    curves_->on_choice = [this](bool come) { settings_.set_curves_come(come); };
    actions_->on(ActionId::toggle_plots, [this, &plots] {
        curves_->set_comes_by_itself(plots.isChecked());
        settings_.set_curves_come(plots.isChecked());
        show_dock(*curves_, plots.isChecked());
    });
    connect(curves_, &QDockWidget::visibilityChanged, &plots, &QAction::setChecked);
    QAction& panels = (*actions_)[ActionId::toggle_panels];
    panels.setChecked(true);
    actions_->on(ActionId::toggle_panels, [this, &panels] {
        for (QDockWidget* dock : findChildren<QDockWidget*>()) {
            if (dock == curves_ || dock == branches_) continue;
            const bool has_use = dock == review_    ? review_->reviewing()
                                 : dock == lessons_ ? lessons_->playing()
                                                    : true;
            dock->setVisible(panels.isChecked() && has_use);
        }
    });
}

// Two views side by side have no room for panels at the right, of which a review needs none but its
// own.
void MainWindow::make_room_beside(bool room) {
    if (room == std::exchange(room_beside_, room)) return;
    if (!room) {
        for (QDockWidget* dock : put_aside_) dock->show();
        for (QDockWidget* dock : std::exchange(put_aside_, {})) dock->raise();
        return;
    }
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock != review_ && dockWidgetArea(dock) == Qt::RightDockWidgetArea &&
            !dock->isHidden() && !dock->isFloating())
            put_aside_.push_back(dock);
    std::ranges::stable_sort(
        put_aside_, {}, [](const QDockWidget* dock) { return !dock->visibleRegion().isEmpty(); });
    for (QDockWidget* dock : put_aside_) dock->hide();
}

// Liver surface, and the plane that opens the view.
void MainWindow::connect_context() {
    QAction& liver = (*actions_)[ActionId::toggle_liver];
    LiverKeeper::Screen screen;
    screen.show = [this](const TriangleMesh& surface) {
        view_->scene().set_liver(surface);
        view_->draw_again();
    };
    screen.none = [this] {
        messages_->show_notice(Words::tr(
            "This case knows no liver. Reconstruct the CT, with a mask of the liver where the "
            "program does not find it by itself."));
    };
    screen.failed = [this](const Failure& failure) {
        fail(Words::tr("The liver's surface"), failure);
    };
    liver_ = std::make_unique<LiverKeeper>(std::move(screen));
    actions_->on(ActionId::toggle_liver, [this, &liver] {
        view_->scene().set_liver_visible(liver.isChecked());
        liver_->set_wanted(liver.isChecked());
        view_->draw_again();
    });
    QAction& open = (*actions_)[ActionId::toggle_clip];
    actions_->on(ActionId::toggle_clip, [this, &open] {
        ClipControl& clip = view_->mouse().clip();
        open.isChecked() ? clip.open_at(view_->scene().axes().focus_mm) : clip.close();
        view_->draw_again();
        statusBar()->showMessage(
            open.isChecked() ? Words::tr("What lies before the middle of the view is taken away: D "
                                         "opens it deeper, Shift+D less deep")
                             : QString(),
            6000);
    });
    const auto shift = [this](double by_mm) {
        ClipControl& clip = view_->mouse().clip();
        clip.shift(by_mm);
        view_->draw_again();
        const double depth_mm = clip.depth_mm();
        statusBar()->showMessage(
            !clip.is_open()   ? Words::tr("The view is whole: O opens it")
            : depth_mm >= 0.0 ? Words::tr("Opened %L1 mm behind where it was put").arg(depth_mm)
                              : Words::tr("Opened %L1 mm before where it was put").arg(-depth_mm),
            6000);
    };
    actions_->on(ActionId::clip_deeper, [shift] { shift(clip_step_mm); });
    actions_->on(ActionId::clip_less_deep, [shift] { shift(-clip_step_mm); });
}

void MainWindow::connect_themes() {
    auto* group = new QActionGroup(this);
    const Theme& now = theme_named(settings_.theme());
    for (std::size_t t = 0; t < theme_actions.size(); ++t) {
        const Theme& theme = themes()[t];
        QAction& action = (*actions_)[theme_actions[t]];
        group->addAction(&action);
        action.setChecked(&theme == &now);
        actions_->on(theme_actions[t], [this, &theme] {
            settings_.set_theme(theme.name);
            apply_theme(*qApp, theme);
            view_->scene().set_look(theme.view);
            view_->draw_again();
            second_view_->take_after_first();
        });
    }
    view_->scene().set_look(now.view);
}

void MainWindow::connect_picture_parts() {
    const auto connect_part = [this](ActionId id, bool shown, auto show) {
        QAction& action = (*actions_)[id];
        action.setChecked(shown);
        actions_->on(id, [this, &action, show] {
            show(action.isChecked());
            view_->draw_again();
            second_view_->take_after_first();
        });
    };
    SceneView& scene = view_->scene();
    connect_part(ActionId::toggle_annotations, true,
                 [&scene](bool shown) { scene.set_annotations_visible(shown); });
    connect_part(ActionId::toggle_halos, true,
                 [&scene](bool shown) { scene.set_halos_visible(shown); });
    connect_part(ActionId::toggle_stretch, false, [this, &scene](bool shown) {
        scene.set_stretch_visible(shown);
        if (patient_) view_->show_frame(frame());
    });
    connect_part(ActionId::toggle_blood, true, [this, &scene](bool shown) {
        scene.set_blood_visible(shown);
        if (patient_) view_->show_frame(frame());
    });
}

void MainWindow::show_as_first(VtkWidget& view) {
    SceneView& scene = view.scene();
    for (std::size_t t = 0; t < theme_actions.size(); ++t)
        if ((*actions_)[theme_actions[t]].isChecked()) scene.set_look(themes()[t].view);
    scene.set_annotations_visible((*actions_)[ActionId::toggle_annotations].isChecked());
    scene.set_halos_visible((*actions_)[ActionId::toggle_halos].isChecked());
    scene.set_warnings_visible(tool_panel_->shows_warnings());
    if (patient_) scene.set_rest_positions(patient_->patient->mesh.vertices_mm);
    scene.set_stretch_visible((*actions_)[ActionId::toggle_stretch].isChecked());
    scene.set_blood_visible((*actions_)[ActionId::toggle_blood].isChecked());
    view.mouse().set_scheme(view_->mouse().scheme());
}

void MainWindow::connect_mouse_schemes() {
    auto* menu = new QMenu(Words::tr("Mous&e"), this);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    const MouseScheme& now = mouse_scheme_named(settings_.mouse_scheme());
    for (const MouseScheme& scheme : mouse_schemes()) {
        QAction* action = group->addAction(Words::tr(scheme.words));
        action->setObjectName(QString("mouse_") + scheme.name);
        action->setToolTip(Words::tr(scheme.tip));
        action->setCheckable(true);
        action->setChecked(&scheme == &now);
        menu->addAction(action);
        connect(action, &QAction::triggered, this, [this, &scheme] {
            settings_.set_mouse_scheme(scheme.name);
            view_->mouse().set_scheme(scheme);
            second_view_->take_after_first();
        });
    }
    view_->mouse().set_scheme(now);
    QMenu* views = menuBar()->actions().at(2)->menu();
    views->addSeparator();
    views->addMenu(menu);
}

void MainWindow::connect_units() {
    int number = 0;
    auto* menu = new QMenu(Words::tr("U&nits"), this);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    for (const FlowUnits units : all_flow_units) {
        QAction* action = group->addAction(numbered(++number, choice_words(units)));
        action->setObjectName("units_" + name_of(units));
        action->setToolTip(Words::tr("Of flows and pressures in the panels and curves"));
        action->setCheckable(true);
        menu->addAction(action);
        connect(action, &QAction::triggered, this, [this, units] { inject_->choose_units(units); });
        // They may have been chosen in the panel.
        connect(menu, &QMenu::aboutToShow, action,
                [this, action, units] { action->setChecked(inject_->units() == units); });
    }
    menuBar()->actions().at(2)->menu()->addMenu(menu);
}

// Widgets keep their language, so the window is made again.
void MainWindow::connect_languages() {
    int number = 0;
    auto* menu = new QMenu(Words::tr("Lang&uage"), this);
    auto* group = new QActionGroup(menu);
    for (const Language& language : languages()) {
        const QString code = language.code;
        const QString name =
            code.isEmpty() ? Words::tr(language.name) : QString::fromUtf8(language.name);
        QAction* action = group->addAction(numbered(++number, name));
        action->setObjectName("language_" + code);
        action->setCheckable(true);
        action->setChecked(code == settings_.language());
        menu->addAction(action);
        connect(action, &QAction::triggered, this, [this, code] { speak(code); });
    }
    menuBar()->actions().at(2)->menu()->addMenu(menu);
}

void MainWindow::speak(const QString& code) {
    settings_.set_language(code);
    const QString text = Words::tr("The language changes at the next start.");
    if (language_of(code) == spoken_language()) {  // "System" and its language by name are one
        if (messages_->text() == text) messages_->dismiss();
        return;
    }
    if (!begin_anew_) return messages_->show_notice(text);
    messages_->show_notice(text, Words::tr("Restart now"), [this] {
        begins_anew_ = true;
        close();
    });
}

void MainWindow::connect_measuring() {
    Measurements& measurements = view_layout_->slices().measurements();
    ViewRuler::Screen screen;
    screen.show = [this](std::vector<MeasureView> measures) {
        if (view_->scene().set_measures(std::move(measures))) view_->draw_again();
    };
    screen.say = [this](const std::string& text) {
        statusBar()->showMessage(QString::fromStdString(text), 8000);
    };
    screen.frame = [this] { return patient_ ? &frame() : nullptr; };
    ruler_ = std::make_unique<ViewRuler>(measurements, std::move(screen));
    for (std::size_t k = 0; k < measuring_actions.size(); ++k)
        actions_->on(measuring_actions[k],
                     [&measurements, k] { measurements.choose(static_cast<MeasurementKind>(k)); });
    actions_->on(ActionId::remove_measurement, [&measurements] { measurements.remove_last(); });
    actions_->on(ActionId::clear_measurements, [this] { remove_measurements(); });
    measurements.on_work([this, &measurements] { keeper_->measure(measurements.kept()); });
    measurements.on_change([this, last = std::optional<MeasurementKind>()]() mutable {
        const auto chosen = view_layout_->slices().measurements().chosen();
        if (std::exchange(last, chosen) != chosen) follow_measuring();
    });
}

// No undo knows of them: they can be had back at once.
void MainWindow::remove_measurements() {
    Measurements& measurements = view_layout_->slices().measurements();
    const std::vector<KeptMeasurement> removed = measurements.remove_all();
    if (removed.empty()) return;
    const auto bring_back = [this, removed, opening = workspace().opening()] {
        if (workspace().opening() == opening)
            view_layout_->slices().measurements().bring_back(removed, workspace().patient()->tree);
    };
    messages_->show_notice(
        Words::tr("%n measurement(s) removed.", nullptr, static_cast<int>(removed.size())),
        Words::tr("Bring back"), bring_back);
}

// Returns how many diameters have no vessel. Those that an earlier run left wait for its
// corrections, whose body is still to be made.
std::size_t MainWindow::show_in_slices(bool corrected) {
    if (corrected) return view_layout_->show_corrected(patient_->patient);
    view_layout_->show_patient(patient_->patient, patient_->folder, patient_->image);
    const std::size_t lost =
        view_layout_->slices().measurements().show(workspace().measured(), patient_->patient->tree);
    return workspace().awaits_body() ? 0 : lost;
}

// Of diameters whose vessel a correction has taken, or another program. Warnings of the same
// vessels, which have come since `said_before` or stand still, remain beside it.
void MainWindow::tell_lost_diameters(std::size_t lost, const QString& said_before) {
    if (lost == 0) return;
    const QString text = Words::tr(
        "%n diameter(s) are not shown any more: the vessel that they were measured on is gone. "
        "Where it comes back, as by Undo, they do.",
        nullptr, static_cast<int>(lost));
    log_->add_warning(Words::tr("Measure"), text);
    const bool warnings_stand = !warnings_text_.isEmpty() && messages_->text() == warnings_text_;
    if (!warnings_stand && messages_->text() == said_before) return messages_->show_notice(text);
    messages_->put_before(text);
    if (warnings_stand) warnings_text_ = messages_->text();
}

// The choice in the menu and the one above the slices are the same and hold in all views.
void MainWindow::follow_measuring() {
    const auto chosen = view_layout_->slices().measurements().chosen();
    const bool measures = view_->mouse().mode() == MouseMode::measure;
    if (chosen) {
        (*actions_)[measuring_actions[static_cast<std::size_t>(*chosen)]].setChecked(true);
        if (!measures) set_mouse_mode(MouseMode::measure);
        statusBar()->showMessage(ruler_->guidance(), 8000);
    } else if (measures) {
        back_to_pulling();
        // What a click in the slices does now is said above them.
        const SliceScene& slices = view_layout_->slices();
        if (slices.pen().taken() || slices.corrects() || slices.brushing() ||
            slices.seeds().taken())
            statusBar()->clearMessage();
    }
}

void MainWindow::inject(const SurfacePick& pick) {
    if (frame().drug.arrival_s)
        hint(Words::tr(
            "This injection takes the place of the last one in the picture; what that one "
            "reached and gave stays counted in a lesson"));
    post(inject_->injection_at(pick.position_mm));
}

}  // namespace hepatica
