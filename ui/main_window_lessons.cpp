// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for lessons: connects their dock and the lesson editor.
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <algorithm>
#include <functional>
#include <utility>

#include "core/session/script.h"
#include "core/tree/station.h"
#include "ui/core_words.h"
#include "ui/curves_dock.h"
#include "ui/file_name.h"
#include "ui/fit_keeper.h"
#include "ui/inject_panel.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/about_page.h"
#include "ui/lesson_editor/draft_slot.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/lesson_tools.h"
#include "ui/library_dialog.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/paths.h"
#include "ui/pointed_place.h"
#include "ui/quality_panel.h"
#include "ui/questions.h"
#include "ui/recovery.h"
#include "ui/review_dock.h"
#include "ui/save_file_dialog.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"
#include "ui/tool_panel.h"
#include "ui/view_ruler.h"
#include "ui/vtk_widget.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString in_lines(const std::vector<std::string>& sentences) {
    QStringList lines;
    for (const std::string& sentence : sentences) lines << translated(sentence);
    return lines.join("\n");
}

}  // namespace

// Looks which lessons of the library still fit the corrected vessels.
void MainWindow::build_fits() {
    FitKeeper::Ways fits;
    fits.found = [this](const std::vector<ShelvedLesson>& lessons) { tell_unfit(lessons); };
    fits.failed = [this](const Failure& failure) {
        fail(Words::tr("Look which lessons still fit"), failure);
        messages_->show_notice(
            Words::tr("Which lessons still fit the corrected vessels is not known:") + "\n" +
            messages_->text());
    };
    fits_ = std::make_unique<FitKeeper>(std::move(fits));
}

void MainWindow::build_lessons() {
    LessonDock::Ways ways;
    ways.patient = [this] { return patient_ ? patient_->patient : nullptr; };
    ways.back_end = [this] { return back_ends_->for_play(); };
    ways.by_keys = [this](std::span<const LessonTool> tools) { return by_keys(tools, *actions_); };
    ways.tool_and_key = [this](LessonTool tool) { return tool_and_key(tool, *actions_); };
    ways.may_begin = [this] { return may_begin_lesson(); };
    ways.open_built_in = [this] { open_for_lesson(OpenRequest{true, {}}); };
    ways.open_case = [this](const QString& folder) {
        OpenRequest request;
        request.reconstruct.ct = to_path(folder);
        open_for_lesson(request);
    };
    ways.use = [this](std::unique_ptr<Simulation> simulation) {
        use_for_lesson(std::move(simulation));
    };
    ways.step = [this](const QString& words) { statusBar()->showMessage(words, 6000); };
    ways.ended = [this] { stop_after_lesson(); };
    ways.kept = [this] { library_->refresh(); };
    ways.reviewed = [this] {
        return review_->reviewing() ? review_->file() : std::filesystem::path();
    };
    ways.failed = [this](const QString& doing, const std::exception_ptr& error) {
        fail(doing, failure_of(error));
    };
    ways.report = [this](const std::filesystem::path& recording, const std::string& lesson) {
        write_report(recording, lesson);
    };
    ways.look_back = [this](const std::filesystem::path& recording, const std::string& lesson) {
        review_->open(recording, lesson);
    };
    ways.save_table = [this](QWidget& asks, const char* called, const std::string& csv) {
        save_table(asks, settings_.last_folder() + "/" + called + ".csv", csv);
    };
    ways.choose = [this](Settings::Kind kind, const Settings::Ask& ask) {
        return settings_.choose(kind, ask);
    };
    ways.edit = [this] { lesson_editor().show_editor(); };
    ways.unfit = [this](const std::filesystem::path& file, const Lesson& lesson,
                        const std::vector<std::string>& misfits) {
        tell_not_played(file, lesson, misfits);
    };
    ways.left = [this] {
        if (lesson_editor_) lesson_editor_->back_from_trying();
        offer_patient_from_before();
    };
    ways.not_begun = [this] {
        if (lesson_editor_) lesson_editor_->back_from_trying();
    };
    ways.named = [this](const QString& name) { settings_.set_trainee(name); };
    ways.course_chosen = [this](const std::filesystem::path& file) {
        settings_.set_course(to_text(file));
    };
    lessons_ = new LessonDock(std::move(ways), to_path(settings_.recordings_folder()), this);
    lessons_->set_units(flow_units_named(settings_.flow_units()));
    lessons_->set_trainee(settings_.trainee());
    lessons_->set_course(to_path(settings_.course()));
    addDockWidget(Qt::LeftDockWidgetArea, lessons_);
    auto* menu = new QMenu(Words::tr("&Lesson"), menuBar());
    lessons_->fill(*menu);
    menuBar()->insertMenu(menuBar()->actions().back(), menu);  // before Help
}

bool MainWindow::may_begin_lesson() {
    const bool may = !keeper_->makes_vessels();
    if (!may)
        messages_->show_notice(
            Words::tr("No lesson begins while the vessels are corrected: wait for that"));
    return may && may_record_lesson();
}

void MainWindow::use_for_lesson(std::unique_ptr<Simulation> simulation) {
    review_->end();
    dismiss_review_message();
    const bool begins = simulation != nullptr;
    if (begins) dismiss_offered_report();
    if (begins) stop_drawing_a_vessel();
    if (begins) remember_recorded_patient();
    use(std::move(simulation));
    ruler_->hide_made(begins);
    if (!begins) return show_whole();
    const Lesson& lesson = *lessons_->shown();
    const std::optional<TearSpec>& tear = lesson.scene.tear;
    tool_panel_->show_tear_factor(tear ? std::optional(tear->tear_factor) : std::nullopt);
    inject_->choose_drug(lesson.drug);
    // Behind the panel of an earlier tool, it would not be found.
    if (allows(lesson.tools, LessonTool::inject)) findChild<QDockWidget*>("Injection")->raise();
    show_whole_from_the_front();
    light_up(TreePoint{});  // the target, where the lesson has one
    view_->setFocus();      // so that the keys of the tools reach the play
}

// It would change the patient during a lesson or a review.
void MainWindow::stop_drawing_a_vessel() {
    VesselPen& pen = view_layout_->slices().pen();
    if (pen.draws()) pen.give_up();
}

// What runs on, such as a bleeding, would contradict the judgement and use the processor for
// nothing.
void MainWindow::stop_after_lesson() {
    if (frame().drug.injection) patient_->simulation->post(PlayDrug{false});
    patient_->simulation->post(SetPaused{true});
    // Nor is anything held or pressed any more.
    const bool tool = view_->mouse().mode() == MouseMode::tool;
    view_->let_go();
    view_->play_ended();
    back_to_pulling();
    if (tool) hint(Words::tr("The lesson is judged: the tool is put away, and the wheel zooms"));
}

void MainWindow::tell_not_played(const std::filesystem::path& file, const Lesson& lesson,
                                 const std::vector<std::string>& misfits) {
    const QString name = QString::fromStdString(lesson.name);
    messages_->show_notice(
        Words::tr("%1 is not played: the vessels were corrected since it was made, and its "
                  "places lie elsewhere now.")
                .arg(name) +
            "\n" + in_lines(misfits) + "\n" +
            Words::tr("Whoever made it looks at them in the lesson editor and saves it again."),
        Words::tr("Edit the lesson"), [this, file] { lesson_editor().edit(file); });
    log_->add_warning(name, in_lines(misfits));
}

// Everything that a lesson refers to becomes visible, whatever the view was.
void MainWindow::show_whole_from_the_front() {
    if (QAction& cut_open = (*actions_)[ActionId::toggle_clip]; cut_open.isChecked())
        cut_open.trigger();
    view_->scene().look_from(ViewDirection::anterior);
    view_->draw_again();
}

// Of the free play, from where one looks: what came before it had the view for itself.
void MainWindow::show_whole() {
    view_->scene().show_whole();
    view_->draw_again();
}

std::optional<OpenRequest> MainWindow::patient_from_where() const {
    if (!patient_) return std::nullopt;
    OpenRequest request;
    request.built_in = patient_->title == built_in_title;
    request.reconstruct.ct = keeper_->workspace().folder();
    // An unsaved patient cannot be opened again.
    if (!request.built_in && request.reconstruct.ct.empty()) return std::nullopt;
    return request;
}

void MainWindow::open_for_lesson(const OpenRequest& request) {
    // Nobody is asked about unsaved work for the sake of a lesson that cannot begin.
    if (!may_record_lesson()) return lessons_->patient_not_shown();
    std::optional<OpenRequest> before = before_lesson_;
    if (patient_ && !lessons_->playing()) before = patient_from_where();
    // Who is on his way already is not begun anew.
    if (!request.built_in || !keeper_->opens_built_in()) open(request);
    before_lesson_ = before;
}

void MainWindow::offer_patient_from_before() {
    const std::optional<OpenRequest> before = std::exchange(before_lesson_, std::nullopt);
    if (!before) return;
    // The lesson was played on the patient who was shown before.
    if (const auto now = patient_from_where();
        now && now->built_in == before->built_in &&
        (now->built_in || same_place(now->reconstruct.ct, before->reconstruct.ct)))
        return;
    const QString name = before->built_in ? Words::tr("the built-in patient")
                                          : to_text(before->reconstruct.ct.filename());
    messages_->show_notice(
        Words::tr("The lesson's own patient is shown. Before it, it was %1.").arg(name),
        Words::tr("Open %1").arg(name), [this, before] { open(*before); });
}

// A lesson of a packed case has no file of its own until it is taken into the library.
void MainWindow::tell_packed_lessons() {
    if (patient_->packed_lessons.empty()) return;
    QStringList names;
    for (const std::string& name : patient_->packed_lessons) names << QString::fromStdString(name);
    const auto count = static_cast<int>(names.size());
    const bool is_there = library_->holds(patient_->asked_for);
    const QString text =
        (is_there
             ? Words::tr("%n lesson(s) for this patient are in his file: %1. To play them, take "
                         "them out: they then lie beside it in the library.",
                         nullptr, count)
             : Words::tr("%n lesson(s) for this patient are in his file: %1. To play them, take "
                         "the case into the library.",
                         nullptr, count))
            .arg(names.join(", "));
    const QString button =
        is_there ? Words::tr("Take the lessons out") : Words::tr("Take it into the library");
    const auto take_in = [this, file = patient_->asked_for] { library_->open_and_take_in(file); };
    if (messages_->text().isEmpty()) return messages_->show_notice(text, button, take_in);
    const bool warnings_stand = messages_->text() == warnings_text_;
    messages_->put_before(text);
    messages_->offer_also(button, take_in);
    if (warnings_stand) warnings_text_ = messages_->text();
}

void MainWindow::tell_unfit(const std::vector<ShelvedLesson>& lessons) {
    if (lessons.empty()) {
        if (!unfit_message_.isEmpty()) log_->settle_warning(unfit_message_);
        if (!unfit_message_.isEmpty() && messages_->text() == unfit_message_) messages_->dismiss();
        return unfit_message_.clear();
    }
    QStringList lines{Words::tr("%n lesson(s) for this patient fit his vessels no more:", nullptr,
                                static_cast<int>(lessons.size()))};
    for (const ShelvedLesson& lesson : lessons)
        lines << lesson.name + ": " + in_lines(lesson.misfits).replace("\n", " ");
    lines << Words::tr(
        "Nobody can play them until their places were looked at in the lesson "
        "editor. Undo of the correction makes them fit again.");
    const QString text = lines.join("\n");
    if (text == unfit_message_) return;  // told already after an earlier correction
    if (!unfit_message_.isEmpty()) log_->settle_warning(unfit_message_);
    unfit_message_ = text;
    log_->add_warning(Words::tr("Corrections"), text,
                      [this, opening = keeper_->workspace().opening()] {
                          return keeper_->workspace().opening() == opening;
                      });
    messages_->show_notice(text, Words::tr("Edit the lesson"),
                           [this, file = lessons.front().file] { lesson_editor().edit(file); });
}

// Offers a lesson left by an earlier run, unless there is another message.
void MainWindow::offer_unsaved_lesson() {
    draft_slot_ = std::make_unique<DraftSlot>(to_path(settings_.lesson_draft()));
    std::error_code ignored;
    if (!messages_->text().isEmpty() || !std::filesystem::exists(draft_slot_->file(), ignored))
        return;
    messages_->show_notice(
        Words::tr("A lesson was left unsaved when the program ended. It is kept: Lesson > Edit "
                  "lessons shows it as it was."),
        Words::tr("Edit it"), [this] {
            messages_->dismiss();
            lesson_editor().show_editor();
        });
}

void MainWindow::allow_tools() {
    const Lesson* lesson = lessons_->running();
    std::optional<std::vector<LessonTool>> tools;
    if (lesson != nullptr) tools.emplace(lesson->tools);
    const bool reviews = review_->reviewing();
    if (allowed_tools_ == tools && forbids_for_review_ == reviews) return;
    forbids_for_review_ = reviews;
    allowed_tools_ = tools;
    if (reviews)
        actions_->forbid(forbidden_in_review(),
                         Words::tr("Not while you look back on a recording: leave the review "
                                   "first (%1)"));
    else
        actions_->forbid(tools ? forbidden_actions(*tools) : std::set<ActionId>(),
                         Words::tr("The lesson does not allow this: %1"));
    view_->mouse().set_may_pull(!tools || allows(*tools, LessonTool::pull));
    const bool settings = !tools || allows(*tools, LessonTool::settings);
    inject_->allow_settings(settings);
    quality_->allow_settings(settings);
    tool_panel_->allow_settings(settings);
}

// What the lesson wants a drug in, after its verdict too, or the one that is edited; empty where it
// wants none.
std::vector<std::uint8_t> MainWindow::target_of_lesson() const {
    const VesselTree& tree = patient_->patient->tree;
    const Lesson* played = lessons_->shown();
    std::optional<Vec3> from_mm;
    if (played != nullptr && played->target)
        from_mm = position_of(*played->target, tree);
    else if (lesson_editor_ && !lessons_->playing() && !review_->reviewing())
        from_mm = lesson_editor_->target_mm();
    if (!from_mm) return {};
    return patient_->anatomy.downstream_of(nearest_point(tree, *from_mm));
}

LessonEditor& MainWindow::lesson_editor() {
    if (lesson_editor_ == nullptr) build_lesson_editor();
    return *lesson_editor_;
}

void MainWindow::build_lesson_editor() {
    LessonEditor::Ways ways;
    ways.patient = [this] { return patient_ ? patient_->patient : nullptr; };
    ways.shown_patient = [this] {
        if (!patient_) return QString();
        if (patient_->title == built_in_title) return QString("built-in");
        const std::filesystem::path& place = keeper_->workspace().home();
        return place.empty() ? QString(unsaved_patient) : to_text(place);
    };
    ways.ask_for_place = [this] {
        set_mouse_mode(MouseMode::place);
        const QRect seen(view_->mapToGlobal(QPoint()), view_->size());
        if (patient_ && lesson_editor_->frameGeometry().intersects(seen)) wait_for_place();
    };
    ways.ask_no_more = [this] {
        if (view_->mouse().mode() == MouseMode::place) back_to_pulling();
    };
    ways.places_changed = [this] {
        if (!patient_) return;
        view_->scene().set_target(target_of_lesson());
        show_marks();
        view_->draw_again();
    };
    ways.try_out = [this](const Lesson& lesson) { return lessons_->try_out(lesson); };
    ways.which_file = [this]() -> std::optional<std::filesystem::path> {
        const QString file = settings_.choose(Settings::Kind::lesson, [this](const QString& start) {
            return QFileDialog::getOpenFileName(lesson_editor_, Words::tr("Edit lesson"), start,
                                                Words::tr("Lessons (*.json)"));
        });
        return file.isEmpty() ? std::nullopt : std::optional(to_path(file));
    };
    ways.where_to_save = [this](const QString& name) -> std::optional<std::filesystem::path> {
        const QString file = settings_.choose(Settings::Kind::lesson, [&](const QString& start) {
            return ask_where_to_save_file(*lesson_editor_, Words::tr("Save lesson"),
                                          start + "/" + as_file_name(name, "lesson") + ".json",
                                          Words::tr("Lessons (*.json)"));
        });
        return file.isEmpty() ? std::nullopt : std::optional(to_path(file));
    };
    ways.unsaved = [this](bool kept) {
        return ask_unsaved_lesson(shown_of(*lesson_editor_, *this),
                                  lesson_editor_->document().lesson().name, kept);
    };
    ways.failed = [this](const QString& doing, const std::exception_ptr& error) {
        log_->add_failure(doing, failure_of(error));
        tell_failure(shown_of(*lesson_editor_, *this), doing, failure_of(error));
    };
    ways.is_hidden = [this](const Vec3& at) { return is_behind_vessels(view_->scene(), at); };
    ways.tumours = [this] { return view_layout_->slices().tumours().tumours(); };
    if (!draft_slot_) draft_slot_ = std::make_unique<DraftSlot>(to_path(settings_.lesson_draft()));
    lesson_editor_ = new LessonEditor(std::move(ways), draft_slot_->file(), this);
}

// Hides the editor, which covers the vessels, and offers the way back.
void MainWindow::wait_for_place() {
    lesson_editor_->step_aside();
    activateWindow();
    view_->setFocus();
    messages_->show_notice(Words::tr("Click on a vessel: the place is there"),
                           Words::tr("Back to the lesson editor"), [this] { back_to_pulling(); });
    messages_->when_closed([this] { back_to_pulling(); });
    place_message_ = messages_->text();
}

void MainWindow::end_waiting_for_place() {
    if (lesson_editor_) lesson_editor_->come_back();
    if (!place_message_.isEmpty() && messages_->text() == place_message_) messages_->dismiss();
    place_message_.clear();
}

// On the centreline, so that the clicked side does not matter.
void MainWindow::set_lesson_place(const SurfacePick& pick) {
    const TreePoint at = patient_->anatomy.tree_point(frame().origin_of(pick.nearest_vertex));
    const VesselTree& tree = patient_->patient->tree;
    if (at.segment >= 0)
        lesson_editor_->place_clicked(
            station_at(tree.segments[static_cast<std::size_t>(at.segment)], at.arclength_mm)
                .position_mm);
    back_to_pulling();
}

}  // namespace hepatica
