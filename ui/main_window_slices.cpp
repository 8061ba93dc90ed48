// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for the slices of the CT and for corrections of vessels and tumours.
#include <QDockWidget>
#include <QStatusBar>
#include <algorithm>
#include <memory>
#include <utility>

#include "core/tree/station.h"
#include "ui/branch_dock.h"
#include "ui/case_editing.h"
#include "ui/edit_panel.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/patient_place.h"
#include "ui/questions.h"
#include "ui/review_dock.h"
#include "ui/slices/stroke_place.h"
#include "ui/slices/view_layout.h"
#include "ui/vtk_widget.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr const char* not_in_review =
    Words::id("Nothing is corrected during a review: end it first");
constexpr const char* not_in_lesson =
    Words::id("Nothing is corrected during a lesson: leave it first");

}  // namespace

void MainWindow::build_slices(QWidget* parent) {
    ViewLayout::Callbacks callbacks;
    callbacks.ask_for_ct = [this] { return ask_where_ct_lies(*this, settings_); };
    callbacks.crosshair = [this](const std::optional<Vec3>& place) {
        if (view_->scene().set_crosshair(place)) view_->draw_soon();
    };
    const auto said = std::make_shared<QString>();  // text of the last failure
    callbacks.failed = [this, said](const QString& doing, const Failure& failure) {
        fail(doing, failure);
        *said = messages_->text();
    };
    callbacks.other_ct = [this, said] {
        if (!said->isEmpty() && messages_->text() == *said) messages_->dismiss();
    };
    callbacks.draw = [this](const Volume& ct, const std::vector<Vec3>& places,
                            VesselPen::Answered answered) {
        if (review_->reviewing())
            return answered({false, Words::tr("Not drawn: end the review first").toStdString()});
        if (lessons_->running() != nullptr)
            return answered({false, Words::tr("Not drawn: leave the lesson first").toStdString()});
        editing_->draw(ct, places, view_layout_->slices().pen().radius_mm(), std::move(answered));
    };
    callbacks.stop_drawing = [this] { editing_->stop_drawing(); };
    callbacks.correct = [this](const Vec3& place) {
        if (may_correct(not_in_review)) editing_->click_at(place);
    };
    callbacks.remake = [this](std::shared_ptr<const Volume> ct, Mask vessels) {
        if (!may_correct(Words::id("Nothing is rebuilt during a review: end it first"))) return;
        dismiss_for_a_deed();
        keeper_->remake(std::move(ct), std::move(vessels));
    };
    callbacks.paint_tumour = [this](const TreeEdit& stroke) {
        if (!may_correct(not_in_review)) return false;
        dismiss_for_a_deed();
        keeper_->add(stroke);
        say_obstacles_stay();
        warn_of_tumour_outside(stroke);
        return true;
    };
    callbacks.take_strokes_back = [this](std::size_t strokes) {
        for (std::size_t i = 0; i < strokes; ++i) keeper_->undo_tumour_stroke();
        say_obstacles_stay();
    };
    callbacks.paint_vessels = [this](const BrushStroke& stroke) {
        dismiss_for_a_deed();
        keeper_->add_stroke(stroke);
        warn_of_stroke_outside(stroke);
    };
    callbacks.take_vessel_strokes_back = [this](std::size_t strokes) {
        keeper_->take_strokes_back(strokes);
    };
    callbacks.tumours = [this](const TriangleMesh& surface) {
        view_->scene().set_tumours(surface);
        view_->draw_again();
        if (lesson_editor_) lesson_editor_->tumours_changed();
    };
    callbacks.correction = [this] { return editing_->tool_name(); };
    callbacks.reconstruct = [this] { (*actions_)[ActionId::reconstruct].trigger(); };
    callbacks.view_covered = [this](int top, int bottom) {
        if (view_->scene().set_covered(top, bottom)) view_->draw_again();
    };
    view_layout_ = new ViewLayout(view_, settings_, std::move(callbacks), parent);
    show_corrections_with_slices();
}

// Lessons and reviews need the patient unchanged.
bool MainWindow::may_correct(const char* why_not_in_review) {
    const char* why = review_->reviewing()             ? why_not_in_review
                      : lessons_->running() != nullptr ? not_in_lesson
                                                       : nullptr;
    if (why != nullptr) messages_->show_notice(Words::tr(why));
    return why == nullptr;
}

void MainWindow::show_image(std::shared_ptr<const Volume> ct) {
    if (patient_) return;
    show_welcome(ct == nullptr);  // the view's quarter is too small for it
    if (ct == nullptr) {
        view_layout_->clear();
        return end_image();
    }
    view_layout_->show_image(std::move(ct));
    QAction& slices = (*actions_)[ActionId::toggle_slices];
    if (slices.isChecked()) return;
    slices_for_image_ = true;
    slices.trigger();
}

void MainWindow::end_image() {
    QAction& slices = (*actions_)[ActionId::toggle_slices];
    if (std::exchange(slices_for_image_, false) && slices.isChecked()) slices.trigger();
}

// Rebuild would make it a vessel of some system. Needs the organs, which are known as far as the
// case has them.
void MainWindow::warn_of_stroke_outside(const BrushStroke& stroke) {
    if (stroke.erases || !lies_far_outside(stroke, view_layout_->slices().tumours().organs()))
        return;
    const QString text = Words::tr(
                             "This stroke lies far outside the liver (at %1), and Rebuild "
                             "would make a vessel of it. Undo takes it back.")
                             .arg(patient_place_in_words(stroke.path_mm.front()));
    log_->add_warning(Words::tr("Corrections"), text, [this, stroke] {
        return std::ranges::find(keeper_->workspace().strokes(), stroke, &PendingStroke::stroke) !=
               keeper_->workspace().strokes().end();
    });
    messages_->show_notice(text, Words::tr("Undo"), [this, stroke] {
        const std::vector<PendingStroke>& strokes = workspace().strokes();
        if (!strokes.empty() && strokes.back().stroke == stroke)
            return keeper_->take_strokes_back(1);
        say_not_the_last();
    });
}

// A stroke at a tumour does not begin the play anew, and its obstacles are made when it begins.
void MainWindow::say_obstacles_stay() {
    if (!patient_ || frame().obstacles == nullptr) return;
    statusBar()->showMessage(
        Words::tr("Tumours as they are now become obstacles with the next correction of a vessel"),
        8000);
}

void MainWindow::warn_of_tumour_outside(const TreeEdit& edit) {
    if (edit.kind != TreeEditKind::paint_tumour) return;
    const SliceScene& slices = view_layout_->slices();
    const Mask& organs = slices.tumours().organs();
    const BrushStroke stroke = stroke_of(edit);
    const bool cut = !slices.empty() && tumour_is_cut_off(stroke, organs.grid, slices.ct().grid);
    if (!cut && !tumour_lies_outside(stroke, organs)) return;
    const QString text =
        (cut ? Words::tr("This tumour reaches beyond the part of the CT about the liver that a "
                         "case keeps (at %1): what lies outside of it is left out. Undo takes it "
                         "back.")
             : Words::tr("This tumour lies outside the liver (at %1). Undo takes it back."))
            .arg(patient_place_in_words(edit.path_mm.front()));
    log_->add_warning(Words::tr("Corrections"), text, [this, edit] {
        const Workspace::Edits& edits = keeper_->workspace().edits();
        return std::ranges::find(edits, edit) != edits.end();
    });
    messages_->show_notice(text, Words::tr("Undo"), [this, edit] {
        const Workspace::Edits& edits = workspace().edits();
        if (!edits.empty() && edits.back() == edit) return keeper_->undo_tumour_stroke();
        say_not_the_last();
    });
}

// The notice of a stroke or link may outlast it, and the last step is another.
void MainWindow::say_not_the_last() {
    statusBar()->showMessage(
        Words::tr("That step is not the last one any more: Undo takes the last step back"), 8000);
}

// Shows the panel of corrections when clicks in the slices begin to correct.
void MainWindow::show_corrections_with_slices() {
    SliceScene& slices = view_layout_->slices();
    slices.on_change([this, &slices, did = false]() mutable {
        if (!std::exchange(did, slices.corrects()) && did) {
            auto* corrections = findChild<QDockWidget*>("Corrections");
            corrections->show();
            corrections->raise();
        }
    });
}

// Why a vessel was not drawn goes with its places.
void MainWindow::follow_points() {
    SliceScene& slices = view_layout_->slices();
    const auto show_history = [this] {
        steps_at_points_ = steps_of_corrections();
        editing_->show_history();
    };
    slices.measurements().on_change(show_history);
    slices.pen().on_change([this, &slices, show_history] {
        show_history();
        if (slices.pen().places_mm().empty() && !not_drawn_message_.isEmpty() &&
            messages_->text() == not_drawn_message_)
            messages_->dismiss();
    });
}

// Points in the slices go before corrections, unless one was made after them or they are not seen.
bool MainWindow::points_wait() const {
    return view_layout_->slices_visible() && view_layout_->slices().points_wait() &&
           steps_at_points_ == steps_of_corrections();
}

std::pair<std::size_t, std::size_t> MainWindow::steps_of_corrections() const {
    return {keeper_->workspace().edits().size(), keeper_->workspace().strokes().size()};
}

void MainWindow::undo() {
    points_wait() ? view_layout_->slices().take_last_point_back() : keeper_->undo();
}

void MainWindow::build_editing() {
    editing_ = std::make_unique<CaseEditing>(
        *edit_panel_, keeper_->workspace(),
        CaseEditing::Callbacks{
            [this](const TreeEdit& edit) {
                if (!may_correct(not_in_review)) return;
                dismiss_for_a_deed();
                keeper_->add(edit);
            },
            [this](double confidence) {
                if (!may_correct(not_in_review)) return;
                dismiss_for_a_deed();
                keeper_->accept_offers(confidence);
            },
            [this] {
                if (points_wait() || may_correct(not_in_review)) undo();
            },
            [this] {
                if (may_correct(not_in_review)) keeper_->redo();
            },
            [this](const QString& undo, const QString& redo) {
                actions_->show_history(undo, redo);
            },
            [this] { return points_wait(); },
            [this](std::vector<BridgeView> bridges) {
                view_->scene().set_bridges(std::move(bridges));
                view_->draw_again();
            },
            [this](const std::vector<Vec3>& path_mm) {
                SliceScene& slices = view_layout_->slices();
                slices.point_out(path_mm);
                if (!path_mm.empty() && (*actions_)[ActionId::toggle_slices].isChecked())
                    slices.set_crosshair(path_mm[path_mm.size() / 2]);
            },
            [this](const QString& text) { statusBar()->showMessage(text, 8000); },
            [this](const Failure& failure) {
                fail(Words::tr("Drawing a vessel"), failure);
                not_drawn_message_ = messages_->text();
            },
            [this](const QString& text) { warn_of_corrections(text); },
            [this](const QString& text, const TreeEdit& link) { warn_of_link(text, link); },
            [this] {
                if (patient_ && show_marks()) view_->draw_again();
            },
            [this] { return branches_->isVisible() ? chosen_branch_.branch() : -1; }});
    follow_points();
}

void MainWindow::warn_of_corrections(const QString& text) {
    for (const QString& line : text.split('\n'))
        log_->add_warning(Words::tr("Corrections"), line,
                          [this, line, opening = workspace().opening()] {
                              return workspace().opening() == opening && editing_->stands(line);
                          });
    for (QString* standing : {&warnings_text_, &link_message_}) {
        if (standing->isEmpty() || messages_->text() != *standing) continue;
        messages_->put_before(text);
        *standing = messages_->text();
        return;
    }
    messages_->show_notice(text);
}

// At once, because the body of the correction may take half a minute.
void MainWindow::warn_of_link(const QString& text, const TreeEdit& link) {
    for (const QString& line : text.split('\n'))
        log_->add_warning(Words::tr("Corrections"), line, [this, link] {
            return std::ranges::count(workspace().edits(), link) > 0;
        });
    messages_->show_notice(text, Words::tr("Undo"), [this, link] {
        const auto next = workspace().next_undo();
        if (!next || next->edits != Workspace::Edits{link}) return say_not_the_last();
        if (may_correct(not_in_review)) keeper_->undo();
    });
    link_message_ = messages_->text();
    doubtful_link_ = link;
}

void MainWindow::settle_link_warning() {
    if (link_message_.isEmpty() || std::ranges::count(workspace().edits(), doubtful_link_) > 0)
        return;
    if (std::exchange(link_message_, {}) == messages_->text()) messages_->dismiss();
}

// To the centreline, since the vertex itself lies on the wall.
void MainWindow::lead_crosshair_to(int vertex) {
    const TreePoint point = patient_->anatomy.tree_point(vertex);
    if (point.segment < 0) return;
    const VesselSegment& segment =
        patient_->patient->tree.segments[static_cast<std::size_t>(point.segment)];
    view_layout_->slices().set_crosshair(station_at(segment, point.arclength_mm).position_mm);
}

}  // namespace hepatica
