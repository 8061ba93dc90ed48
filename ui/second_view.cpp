// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/second_view.h"

#include <vtkCamera.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/vtk_widget.h"

namespace hepatica {
namespace {

// The second view only shows; it has no effect on the play.
MouseTool::Callbacks nothing() {
    return {[](const Command&) {},
            [](const SurfacePick&) {},
            [](const SurfacePick&) {},
            [](const SurfacePick&) {},
            [](int) {},
            [](const SurfacePick&) { return Vec3(Vec3::Zero()); },
            [](MouseMode, const std::optional<std::array<Vec3, 2>>&) {}};
}

}  // namespace

SecondView::SecondView(VtkWidget& first, std::function<void(VtkWidget&)> as_first, QWidget* parent)
    : QWidget(parent), first_(first), as_first_(std::move(as_first)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2, 0, 0, 0);
    hide();
}

void SecondView::make_view(const std::vector<VascularSystem>& of_vertices, const QString& caption) {
    view_ = new VtkWidget(nothing(), this);
    view_->scene().set_vertex_systems(of_vertices);
    as_first_(*view_);
    view_->scene().set_covered(0, covered_bottom_);
    view_->scene().set_caption(caption.toStdString());
    view_->on_picture([this](const PictureTime&) { lead_first(); });
    layout()->addWidget(view_);
    show();
}

void SecondView::show_frame(const std::shared_ptr<const Frame>& frame, std::vector<MarkView> marks,
                            const std::vector<VascularSystem>& of_vertices,
                            const QString& caption) {
    const bool is_new = view_ == nullptr;
    if (is_new) make_view(of_vertices, caption);
    view_->scene().set_drug_scale(drug_scale_s_);
    const bool marks_moved = view_->scene().set_marks(std::move(marks));
    frame_ = frame;
    view_->show_frame(*frame);
    if (marks_moved) view_->draw_again();
    if (is_new) follow_first();
}

void SecondView::take_after_first() {
    if (view_ == nullptr) return;
    as_first_(*view_);
    if (frame_) view_->show_frame(*frame_);
    view_->draw_again();
}

void SecondView::set_drug_scale(double least_end_s) {
    drug_scale_s_ = least_end_s;
}

void SecondView::keep_clear(int bottom) {
    covered_bottom_ = bottom;
    if (view_ != nullptr && view_->scene().set_covered(0, bottom)) view_->draw_again();
}

void SecondView::clear() {
    delete view_;
    view_ = nullptr;
    frame_.reset();
    shared_.reset();
    hide();
}

SecondView::Sight SecondView::sight_of(VtkWidget& view) {
    vtkCamera& eye = view.scene().camera();
    Sight sight{};
    auto next = sight.begin();
    for (const double* vector : {eye.GetPosition(), eye.GetFocalPoint(), eye.GetViewUp()})
        next = std::copy_n(vector, 3, next);
    *next = eye.GetViewAngle();
    return sight;
}

// A picture that comes late must not take back what the other view was turned since. VTK normalizes
// vectors that it is given, which may change their last bit.
bool SecondView::leads(VtkWidget& view) {
    constexpr double rounding = 1e-9;
    const Sight now = sight_of(view);
    const bool same = shared_ && std::ranges::equal(now, *shared_, [](double a, double b) {
                          return std::abs(a - b) <= rounding * std::max(1.0, std::abs(b));
                      });
    if (!same) shared_ = now;
    return !same;
}

void SecondView::lead_first() {
    if (leads(*view_) && first_.scene().look_as(view_->scene())) first_.draw_again();
}

void SecondView::follow_first() {
    if (view_ != nullptr && leads(first_) && view_->scene().look_as(first_.scene()))
        view_->draw_again();
}

}  // namespace hepatica
