// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/view_layout.h"

#include <QGridLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/opening/patient_image.h"
#include "ui/core_words.h"
#include "ui/slices/slice_bar.h"
#include "ui/slices/slice_notice.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/threshold_dialog.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

ViewLayout::ViewLayout(QWidget* view, Settings& settings, Callbacks callbacks, QWidget* parent)
    : QWidget(parent),
      callbacks_(std::move(callbacks)),
      keeper_(settings, readings_,
              {[this](std::shared_ptr<const Volume> ct, Mask systems) {
                   scene_.show(std::move(ct), std::move(systems), patient_->tree);
                   scene_.brush().show(strokes_);
                   callbacks_.other_ct();
                   want_segments();
                   tumours_.want();
                   tumours_.show_again();
                   arrange();
               },
               [this](const JobProgress& now) { notice_->show_progress(now); },
               [this](const Failure& failure) {
                   notice_->say(in_one_sentence(failure), true);
                   if (!failure.place.empty())
                       callbacks_.failed(Words::tr("Reading the CT"), failure);
               }}),
      segments_({[this](Mask segments) {
                     scene_.set_segments(
                         std::move(segments),
                         Words::tr("This case holds no segments of the liver: they are "
                                   "known where there are a liver mask and a portal vein")
                             .toStdString());
                 },
                 [this](const Failure& failure) {
                     scene_.set_segments({}, Words::tr("The segments cannot be read: %1")
                                                 .arg(translated(failure.problem))
                                                 .toStdString());
                     callbacks_.failed(Words::tr("Liver segments"), failure);
                 }}),
      tumours_({[this](std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes) {
                    scene_.tumours().show(std::move(canvas), std::move(organs), strokes);
                },
                [this] {
                    scene_.tumours().show_none(
                        Words::tr("This case knows no voxels that could be tumour").toStdString());
                },
                [this](const TriangleMesh& surface) { callbacks_.tumours(surface); },
                [this](const Failure& failure) {
                    scene_.tumours().show_none(Words::tr("The tumours cannot be read: %1")
                                                   .arg(translated(failure.problem))
                                                   .toStdString());
                    callbacks_.failed(Words::tr("Tumours"), failure);
                }}),
      view_(view) {
    build(view);
    build_threshold();
    connect_scene();
    arrange();
}

void ViewLayout::build_threshold() {
    threshold_ =
        new ThresholdDialog(scene_,
                            {[this] {
                                 return [patient = patient_, folder = folder_] {
                                     return canvas_voxels(*patient, folder);
                                 };
                             },
                             [this](std::shared_ptr<const Volume> ct, Mask vessels) {
                                 callbacks_.remake(std::move(ct), std::move(vessels));
                             },
                             [this](const Failure& failure) {
                                 callbacks_.failed(Words::tr("More or fewer vessels"), failure);
                             }},
                            this);
}

void ViewLayout::connect_scene() {
    scene_.tumours().on_stroke(
        {[this](const TreeEdit& stroke) {
             if (!callbacks_.paint_tumour(stroke)) tumours_.show_again();
         },
         [this](std::size_t strokes) { callbacks_.take_strokes_back(strokes); },
         [this] { tumours_.show_again(); }});
    scene_.brush().on_stroke({callbacks_.paint_vessels, callbacks_.take_vessel_strokes_back});
    scene_.on_change([this] { mark_crosshair(); });
    scene_.brush().on_remake(
        [this] { callbacks_.remake(scene_.shared_ct(), scene_.painted_vessels()); });
    scene_.seeds().on_reconstruct([this] { callbacks_.reconstruct(); });
    scene_.pen().on_draw({[this](const std::vector<Vec3>& places, VesselPen::Answered answered) {
                              callbacks_.draw(scene_.ct(), places, std::move(answered));
                          },
                          [this] { callbacks_.stop_drawing(); }});
}

ViewLayout::~ViewLayout() = default;

void ViewLayout::build(QWidget* view) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    bar_ = new SliceBar(scene_, callbacks_.correction, this);
    column->addWidget(bar_);
    pictures_ = new QWidget(this);
    column->addWidget(pictures_, 1);
    grid_ = new QGridLayout(pictures_);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(2);
    for (const SliceDirection direction :
         {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal}) {
        auto* slice = new SliceView(scene_, direction, pictures_);
        slice->on_hover([this](const Vec3& place) { bar_->show_place(place); });
        slice->on_say([this](const QString& text) { bar_->say(text); });
        slice->on_correct([this](const Vec3& place) { callbacks_.correct(place); });
        slice->on_double_click([this, slice] { enlarge(enlarged_ ? nullptr : slice); });
        views_[static_cast<std::size_t>(direction)] = slice;
    }
    notice_ = new SliceNotice({[this] { ask(); }, [this] { cancel_reading(); }}, pictures_);
    // The usual order of viewers: axial slice and 3D view above, coronal and sagittal below. The
    // notice stands beside the 3D view.
    grid_->addWidget(views_[0], 0, 0);
    grid_->addWidget(view, 0, 1);
    grid_->addWidget(views_[1], 1, 0);
    grid_->addWidget(views_[2], 1, 1);
    grid_->addWidget(notice_, 0, 2, 2, 1);
}

void ViewLayout::show_patient(std::shared_ptr<const PatientCase> patient,
                              const std::filesystem::path& folder,
                              const std::filesystem::path& image) {
    clear();
    patient_ = patient;
    folder_ = folder;
    segments_.show(patient, folder);
    tumours_.show(patient, folder);
    keeper_.show(std::move(patient), folder, image);
    if (slices_visible_) set_slices_visible(true);
}

void ViewLayout::show_image(std::shared_ptr<const Volume> ct) {
    if (patient_) return;
    scene_.show(std::move(ct), {}, {});
    arrange();
}

std::size_t ViewLayout::show_corrected(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    segments_.show_corrected(patient_);
    const std::size_t lost = scene_.measurements().follow_tree(patient_->tree);
    if (scene_.empty()) return lost;
    // The voxels in memory may differ from those shown.
    if (!patient_->mask.voxels.empty()) scene_.set_systems(patient_->mask);
    scene_.show_tree(patient_->tree);
    want_segments();
    return lost;
}

// Shown once there is a CT.
void ViewLayout::show_strokes(const std::vector<PendingStroke>& strokes) {
    strokes_.clear();
    for (const PendingStroke& pending : strokes) strokes_.push_back(pending.stroke);
    if (!scene_.empty()) scene_.brush().show(strokes_);
}

void ViewLayout::choose_threshold() {
    threshold_->show();
    threshold_->raise();
    threshold_->activateWindow();
}

void ViewLayout::want_segments() {
    if (segments_.want())
        scene_.set_segments({}, Words::tr("The segments are being read").toStdString());
}

void ViewLayout::clear() {
    keeper_.show(nullptr, {}, {});
    segments_.show(nullptr, {});
    tumours_.show(nullptr, {});
    patient_.reset();
    strokes_.clear();
    scene_.clear();
    enlarged_ = nullptr;
    arrange();
}

void ViewLayout::set_slices_visible(bool visible) {
    slices_visible_ = visible;
    if (visible && patient_) {
        const bool was_reading = keeper_.reading();
        keeper_.want();
        if (!was_reading && keeper_.reading()) notice_->show_reading();
    } else if (visible) {
        notice_->say(Words::tr("Open a patient to see slices of the CT."), false);
    }
    arrange();
    mark_crosshair();
}

void ViewLayout::enlarge(SliceView* view) {
    enlarged_ = view;
    arrange();
}

void ViewLayout::arrange() {
    const bool slices = slices_visible_ && !scene_.empty();
    bar_->setVisible(slices && patient_);  // its tools need a patient
    notice_->setVisible(slices_visible_ && !slices);
    for (SliceView* slice : views_) slice->setVisible(slices && (!enlarged_ || enlarged_ == slice));
    view_->setVisible(!slices || !enlarged_);
    const auto there = [this](const QWidget* widget) { return widget->isVisibleTo(this) ? 1 : 0; };
    grid_->setColumnStretch(0, there(views_[0]) | there(views_[1]));
    grid_->setColumnStretch(1, there(view_) | there(views_[2]));
    grid_->setColumnStretch(2, there(notice_));
    grid_->setRowStretch(0, there(views_[0]) | there(view_));
    grid_->setRowStretch(1, there(views_[1]) | there(views_[2]));
    clear_words();
}

void ViewLayout::keep_clear(int top, int bottom) {
    covered_top_ = top;
    covered_bottom_ = bottom;
    clear_words();
}

QImage ViewLayout::picture(const QImage& view) const {
    const bool slices = std::ranges::any_of(
        views_, [this](const SliceView* slice) { return slice->isVisibleTo(this); });
    if (!slices) return view;
    const double ratio = devicePixelRatioF();
    QImage whole((QSizeF(pictures_->size()) * ratio).toSize(), QImage::Format_RGB32);
    whole.setDevicePixelRatio(ratio);
    whole.fill(palette().color(QPalette::Window));
    QPainter painter(&whole);
    for (SliceView* slice : views_)
        if (slice->isVisibleTo(this)) painter.drawPixmap(slice->pos(), slice->grab());
    if (view_->isVisibleTo(this)) painter.drawImage(QRectF(view_->geometry()), view);
    return whole;
}

// A bar at the top covers the upper row and one at the foot the lower row; both cover a picture
// that stands alone.
void ViewLayout::clear_words() {
    const bool two_rows = slices_visible_ && !scene_.empty() && !enlarged_;
    const int at_upper_foot = two_rows ? 0 : covered_bottom_;
    const int at_lower_top = two_rows ? 0 : covered_top_;
    views_[0]->keep_clear(covered_top_, at_upper_foot);
    for (const std::size_t lower : {1U, 2U})
        views_[lower]->keep_clear(at_lower_top, covered_bottom_);
    callbacks_.view_covered(covered_top_, at_upper_foot);
}

void ViewLayout::mark_crosshair() {
    const bool shown = slices_visible_ && !scene_.empty();
    callbacks_.crosshair(shown ? std::optional(scene_.crosshair_mm()) : std::nullopt);
}

void ViewLayout::ask() {
    if (const auto place = callbacks_.ask_for_ct()) {
        callbacks_.other_ct();
        keeper_.read_from(*place);
        notice_->show_reading();
    }
}

void ViewLayout::cancel_reading() {
    keeper_.cancel();
    notice_->say(Words::tr("The CT was not read. Hide the slices and show them again (F7) to read "
                           "it, or choose another one."),
                 true);
}

}  // namespace hepatica
