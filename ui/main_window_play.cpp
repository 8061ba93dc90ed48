// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for the play: shows the patient and passes on the user's actions.
#include <QDockWidget>
#include <QGuiApplication>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "core/lesson/allowed_commands.h"
#include "ui/branch_dock.h"
#include "ui/case_editing.h"
#include "ui/core_words.h"
#include "ui/curves_dock.h"
#include "ui/dial_keeper.h"
#include "ui/fit_keeper.h"
#include "ui/inject_panel.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/liver_keeper.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/paths.h"
#include "ui/play_sounds.h"
#include "ui/quality_panel.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"
#include "ui/status_line.h"
#include "ui/tool_panel.h"
#include "ui/view_ruler.h"
#include "ui/volume_keeper.h"
#include "ui/vtk_widget.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::show_patient(LoadedPatient patient, bool corrected) {
    end_recording();
    const QString said_before = messages_->text();
    SceneView& scene = view_->scene();
    end_image();
    // Forgets the former patient, so that the camera finds the new one.
    if (!corrected) scene.show(Frame{});
    if (!corrected) solver_said_.clear();
    curves_->clear();
    lessons_->end_play();  // before the first of the new frames
    kept_play_.drop();
    shows_free_play_ = true;
    sounds_->begin();
    patient_ = std::move(patient);
    dial_->show(patient_->patient, back_ends_->for_play());
    hovered_vertex_ = -1;
    chosen_branch_.forget();
    scene.set_chosen_branch({});
    show_welcome(false);
    scene.set_highlight({});
    scene.set_target({});
    scene.set_marks({});
    scene.set_vertex_systems(patient_->anatomy.vertex_systems());
    scene.set_vertex_segments({});
    scene.set_rest_positions(patient_->patient->mesh.vertices_mm);
    ruler_->show_patient(patient_->patient);
    actions_->set_patient_shown(true);
    quality_->post_choices();
    inject_->begin_play(true);
    view_->mouse().hand().begin_again();
    use_body(true);
    tool_panel_->begin_play(true);
    follow_simulation();
    editing_->show_body();
    const std::size_t lost = show_in_slices(corrected);
    if (!corrected) {
        show_what_it_was_made_with();
        // The former patient's plane would cut the new one anywhere.
        if (QAction& open = (*actions_)[ActionId::toggle_clip]; open.isChecked()) open.trigger();
        liver_->show_patient(patient_->patient, patient_->folder);
        volume_->show_patient(patient_->patient, patient_->folder, patient_->image);
        show_reading_of_volume();
    }
    branches_->show_patient(patient_->patient, patient_->flow_shares,
                            keeper_->workspace().folder());
    show_warnings(corrected);
    tell_lost_diameters(lost, said_before);
    if (!corrected) tell_packed_lessons();
    if (!corrected)
        attempt(Words::tr("Open the unsaved work"), [this] { tell_unsaved_work_of_case(); });
    if (corrected) {
        lessons_->patient_corrected();
        fits_->look(patient_->patient, keeper_->workspace().home(),
                    to_path(settings_.library_folder()));
    } else {
        unfit_message_.clear();  // was of the former patient
        fits_->patient_opened(patient_->patient->tree);
        lessons_->patient_shown(patient_->title == built_in_title, patient_->asked_for);
    }
    allow_tools();
    if (lesson_editor_) lesson_editor_->patient_shown();
    review_->patient_shown();
}

// In a scene without deformation frames hold the surface's vertices, not the body's.
void MainWindow::match_anatomy() {
    const PatientCase& patient = *patient_->patient;
    const bool moves = frame().positions_mm.size() >= 3 * patient.mesh.vertices_mm.size();
    Job job;
    patient_->anatomy = SurfaceAnatomy(
        patient.tree, moves ? patient.mesh.vertices_mm : patient.surface.vertices_mm, job);
    view_->scene().set_vertex_systems(patient_->anatomy.vertex_systems());
    view_->scene().set_rest_positions(moves ? patient.mesh.vertices_mm : std::vector<Vec3>{});
    branches_->colour_vessels();  // if the branches of this patient are known
    use_body(moves);
}

void MainWindow::use(std::unique_ptr<Simulation> simulation) {
    if (!patient_) return;
    end_recording();
    const bool free = simulation == nullptr;
    // Lessons record themselves, and a review shows a recording.
    (*actions_)[ActionId::record_play].setEnabled(free);
    if (free) simulation = kept_play_.give_back(back_ends_->chosen());
    const bool comes_back = simulation != nullptr && free;
    if (simulation == nullptr) {
        Job job;
        simulation = play_with(back_ends_->for_play(), patient_->patient, job).simulation;
    }
    if (std::exchange(shows_free_play_, free) && !free)
        kept_play_.take(std::move(patient_->simulation),
                        {back_ends_->chosen(), quality_->choices(), curves_->tears()});
    patient_->simulation = std::move(simulation);
    // What was measured since the patient was opened; a play that comes back was told.
    if (const auto dial = dial_->dial(); dial && !comes_back) patient_->simulation->use_dial(*dial);
    sounds_->begin();
    patient_->simulation->update_frame();
    match_anatomy();
    curves_->clear();
    if (comes_back) {
        curves_->show_tears(kept_play_.shown().tears);
        quality_->show_choices(kept_play_.shown().settings);
    }
    hovered_vertex_ = -1;
    view_->scene().set_highlight({});
    view_->scene().set_target({});
    show_marks();  // the next frame may take a while
    view_->show_frame(frame());
    if (free && !comes_back) quality_->post_choices();  // a lesson has settings of its own
    inject_->begin_play(free);
    view_->mouse().hand().forget();
    comes_back ? tool_panel_->go_on() : tool_panel_->begin_play(free);
    allow_tools();
    back_to_pulling();
    follow(frame());
    follow_simulation();
    if (comes_back)
        statusBar()->showMessage(Words::tr("The play from before is shown again"), 6000);
}

void MainWindow::colour_by_segments(const std::vector<std::uint8_t>& of_branches) {
    std::vector<std::uint8_t> of_vertices;
    const std::size_t vertices = patient_ ? patient_->anatomy.vertex_systems().size() : 0;
    if (!of_branches.empty())
        for (std::size_t v = 0; v < vertices; ++v) {
            const int branch = patient_->anatomy.tree_point(static_cast<int>(v)).segment;
            of_vertices.push_back(branch < 0 ? 0 : of_branches[static_cast<std::size_t>(branch)]);
        }
    view_->scene().set_vertex_segments(std::move(of_vertices));
    view_->draw_again();
}

// Of what a correction makes doubtful case_editing.h tells; it tells all again only where they were
// still to be read.
void MainWindow::show_warnings(bool corrected) {
    const std::vector<std::string> before = std::exchange(warnings_, patient_->warnings);
    const std::uint64_t origin = keeper_->workspace().origin();
    const bool other_vessels = std::exchange(warnings_origin_, origin) != origin;
    for (const std::string& warning : before)
        if (!corrected || std::ranges::find(warnings_, warning) == warnings_.end())
            log_->settle_warning(translated(warning));
    status_->show_warnings(warnings_.size());
    const QString said = messages_->text();
    bool fresh = false;
    for (const std::string& warning : warnings_) {
        const bool told = corrected && std::ranges::find(before, warning) != before.end();
        if (told || said.contains(translated(warning))) continue;
        fresh |= !corrected || other_vessels;
        log_->add_warning(translated(keeper_->workspace().title()), translated(warning));
    }
    log_->settle();
    const bool stand = !warnings_text_.isEmpty() && said == warnings_text_;
    if (stand) messages_->dismiss();
    if (!warnings_.empty() && (fresh || stand)) tell_warnings();
}

void MainWindow::tell_warnings() {
    warnings_text_ = in_short(warnings_);
    messages_->show_notice(warnings_text_, Words::tr("All messages"), [this] { log_->show(); });
    warnings_text_ = messages_->text();
}

void MainWindow::dismiss_for_a_deed() {
    if (warnings_text_.isEmpty() || messages_->text() != warnings_text_) messages_->dismiss();
}

// The patient's title; empty: none. Safe mode is shown too.
void MainWindow::show_title(const QString& patient) {
    QString title = "Hepatica";
    if (settings_.safe()) title += " " + Words::tr("(safe mode: nothing is remembered)");
    setWindowTitle(patient.isEmpty() ? title : patient + "[*] - " + title);
}

void MainWindow::show_workspace() {
    const Workspace& workspace = keeper_->workspace();
    if (!workspace.has_patient()) return;
    show_title(translated(workspace.title()));
    setWindowModified(workspace.unsaved());
    show_caption(translated(workspace.title()));
    recovery_->follow(workspace);
    tell_other_user();
    if (lesson_editor_ && workspace.folder() != told_folder_) lesson_editor_->patient_shown();
    told_folder_ = workspace.folder();
    editing_->update_panel();
    view_layout_->show_tumours(workspace.edits());
    view_layout_->show_strokes(workspace.strokes());
    settle_link_warning();
    log_->settle();
    keep_dial();
}

void MainWindow::keep_dial() {
    const Workspace& workspace = keeper_->workspace();
    const std::filesystem::path& place =
        workspace.folder().empty() ? patient_->cached_case : workspace.folder();
    dial_->keep_in(workspace.dirty() ? std::filesystem::path() : place, workspace.patient().get());
}

void MainWindow::show_caption(const QString& text) {
    if (view_->scene().set_caption(text.toStdString())) view_->draw_again();
}

void MainWindow::follow_simulation() {
    patient_->simulation->on_frame([this] {
        if (frame_waits_.exchange(true)) return;
        QMetaObject::invokeMethod(
            this, [this] { show_newest_frame(); }, Qt::QueuedConnection);
    });
    show_newest_frame();  // for frames that came before
}

void MainWindow::show_newest_frame() {
    if (const int wait_ms = view_->wait_before_picture_ms(); wait_ms > 0) {
        QTimer::singleShot(wait_ms, Qt::PreciseTimer, this, [this] { show_newest_frame(); });
        return;
    }
    frame_waits_ = false;  // first, so that frames from here on are announced again
    if (!patient_ || !patient_->simulation->update_frame()) return;
    const bool marks_moved = show_marks();
    view_->show_frame(frame());
    ruler_->follow();
    if (marks_moved) view_->draw_again();
    follow(frame());
    show_figures_soon();
}

bool MainWindow::show_marks() {
    std::vector<MarkView> marks;
    if (review_->reviewing())
        marks = review_->marks_in(frame());
    else if (lessons_->playing())
        marks = lessons_->marks_in(frame());
    else if (lesson_editor_)
        for (const Vec3& place : lesson_editor_->places()) marks.push_back({place, "", false});
    if (editing_ && editing_->link_from_mm())
        marks.push_back({*editing_->link_from_mm(), "", false, false});
    std::vector<Vec3> branch = line_of_chosen_branch();
    if (marks.empty() && !branch.empty())
        marks.push_back({branch[branch.size() / 2], "", false, false});
    const bool branch_moved = view_->scene().set_chosen_branch(std::move(branch));
    return view_->scene().set_marks(std::move(marks)) || branch_moved;
}

std::vector<Vec3> MainWindow::line_of_chosen_branch() {
    if (!patient_ || !branches_->isVisible()) return {};
    return chosen_branch_.line_in(frame());
}

void MainWindow::tell_dial_keeper() {
    dial_->set_busy(busy() || !patient_ || !frame().statistics.resting);
}

bool MainWindow::plays_freely() const {
    return lessons_->running() == nullptr;
}

void MainWindow::follow(const Frame& frame) {
    tell_dial_keeper();
    (*actions_)[ActionId::pause_simulation].setChecked(frame.statistics.paused);
    (*actions_)[ActionId::restore].setEnabled(frame.statistics.diverged);
    inject_->show_drug(frame.drug);
    curves_->follow(patient_->patient, frame.drug, plays_freely());
    sound(frame);
}

void MainWindow::show_figures_soon() {
    if (!figures_timer_->isActive()) figures_timer_->start();
}

void MainWindow::show_figures() {
    if (picture_ms_ > 0.0) status_->show_picture_time(picture_ms_);
    if (!patient_) return status_->clear_statistics();
    const Frame& frame = patient_->simulation->frame();
    FrameStatistics statistics = frame.statistics;
    statistics.paused |= review_->reviewing() && !review_->playing();
    status_->show_statistics(statistics, review_->reviewing());
    status_->show_bleeding(frame.tear, flow_units_named(settings_.flow_units()));
    quality_->show_statistics(frame.statistics);
    tool_panel_->show_force(frame.tool, frame.grab);
    tool_panel_->show_contact(frame);
    tool_panel_->show_tear(frame.tear);
    if (!cuts_message_.isEmpty() && (!frame.tear || frame.tear->joints_broken == 0))
        if (std::exchange(cuts_message_, {}) == messages_->text()) messages_->dismiss();
    curves_->follow_tear(frame, lessons_->shows_play() || review_->of_lesson());
    lessons_->show_figures();
    sound(frame);  // the verdict may come after the last frame
    allow_tools();
    const bool injected = frame.drug.arrival_s != nullptr;
    curves_->set_time(injected ? std::optional(frame.drug.time_s) : std::nullopt);
    show_message_of(frame);
}

void MainWindow::show_hover(const SurfacePick& pick) {
    if (!patient_) return;
    if (pick.nearest_vertex == hovered_vertex_) return;
    hovered_vertex_ = pick.nearest_vertex;
    const int vertex = frame().origin_of(pick.nearest_vertex);
    if (QGuiApplication::keyboardModifiers() & Qt::ShiftModifier) lead_crosshair_to(vertex);
    const TreePoint point = patient_->anatomy.tree_point(vertex);
    if (QGuiApplication::keyboardModifiers() & Qt::ShiftModifier) branches_->select(point.segment);
    inject_->show_hover(translated(patient_->anatomy.describe(point, patient_->flow_shares)));
    light_up(point);
}

void MainWindow::light_up(const TreePoint& under_mouse) {
    SceneView& scene = view_->scene();
    // While the pointer is on no vessel: the branch chosen in the table.
    const int chosen = chosen_branch_.branch();
    if (under_mouse.segment < 0 && chosen >= 0 && branches_->isVisible())
        scene.set_highlight(patient_->anatomy.vertices_of(chosen), HighlightOf::branch);
    else
        scene.set_highlight(patient_->anatomy.downstream_of(under_mouse));
    scene.set_target(target_of_lesson());
    show_marks();
    view_->draw_again();
}

void MainWindow::tear(MouseMode mode, const std::optional<std::array<Vec3, 2>>& stroke) {
    view_->draw_again();
    if (!patient_) return;
    if (!stroke) {
        return hint(Words::tr("The line meets no vessel: draw it across one"));
    }
    statusBar()->clearMessage();  // such as that of a line before
    if (!frame().tear) post(tool_panel_->tear());
    const auto& [from, to] = *stroke;
    if (mode == MouseMode::cut) return post(Blade{from, to});
    const Vec3 middle = 0.5 * (from + to);  // the cross-section at the middle
    post(CutLine{middle, middle, tool_panel_->cut_line_strength()});
}

void MainWindow::picture_shown(const PictureTime& time) {
    if (picture_ms_ == 0.0) status_->show_renderer(view_->renderer_name());
    picture_ms_ = time.on_screen_ms;
    if (patient_) patient_->simulation->set_drawing_ms(time.processor_ms);
    second_view_->follow_first();
    show_figures_soon();
    if (first_picture_) QTimer::singleShot(0, this, std::exchange(first_picture_, nullptr));
}

void MainWindow::post(Command command) {
    if (!patient_) return;
    // A forbidden command is reported; it does not end the attempt.
    if (const Lesson* lesson = lessons_->running())
        if (const std::string objection = objection_to(command, *lesson); !objection.empty())
            return hint(translated(objection));
    if (lessons_->begins_with(command)) patient_->simulation->post(SetPaused{false});
    patient_->simulation->post(std::move(command));
}

void MainWindow::set_mouse_mode(MouseMode mode) {
    view_->mouse().set_mode(mode);
    if (mode != MouseMode::place) end_waiting_for_place();
    Measurements& measurements = view_layout_->slices().measurements();
    if (mode != MouseMode::measure && measurements.chosen()) measurements.choose(std::nullopt);
    if (auto* button = findChild<QToolButton*>("measureButton"))
        button->setChecked(mode == MouseMode::measure);
    view_->setCursor(mode == MouseMode::pull ? Qt::ArrowCursor : Qt::CrossCursor);
    if (editing_) editing_->set_edit_mode(mode == MouseMode::edit);
    const bool draws = mode == MouseMode::cut || mode == MouseMode::weaken;
    tool_panel_->show_kind(view_->mouse().hand().kind(), draws ? guidance_of(mode) : QString());
    if (mode == MouseMode::tool || draws) findChild<QDockWidget*>("Tool")->raise();
    if (mode == MouseMode::edit) {
        // What a click does is chosen there, so it is shown again where it was closed.
        findChild<QDockWidget*>("Corrections")->show();
        findChild<QDockWidget*>("Corrections")->raise();
    }
    if (mode == MouseMode::inject) findChild<QDockWidget*>("Injection")->raise();
    constexpr int readable_ms = 6000;
    statusBar()->showMessage(guidance_of(mode), readable_ms);
    view_->mode_chosen();
}

// Also if a lesson forbids pulling; then a drag does nothing to the vessels.
void MainWindow::back_to_pulling() {
    (*actions_)[ActionId::pull_mode].setChecked(true);
    set_mouse_mode(MouseMode::pull);
}

void MainWindow::take_tool(const std::string& kind) {
    show_hover(SurfacePick{});
    view_->mouse().hand().take(kind);
    set_mouse_mode(MouseMode::tool);
}

}  // namespace hepatica
