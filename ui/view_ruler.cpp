// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view_ruler.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "ui/body_anchors.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// A point of a slice that is farther from all vessels does not move with one.
constexpr double reach_mm = 10.0;
// A smaller displacement counts as at rest.
constexpr double moved_mm = 0.5;

}  // namespace

ViewRuler::ViewRuler(Measurements& measurements, Screen screen)
    : measurements_(measurements), screen_(std::move(screen)) {
    measurements_.on_change([this] {
        hidden_ = std::min(hidden_, measurements_.made().size());
        anchored_to_ = nullptr;
        follow();
    });
}

void ViewRuler::show_patient(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    hidden_ = 0;
    anchored_to_ = nullptr;
}

void ViewRuler::hide_made(bool hide) {
    hidden_ = hide ? measurements_.made().size() : 0;
    anchored_to_ = nullptr;
    follow();
}

std::vector<const Measurement*> ViewRuler::drawn() const {
    std::vector<const Measurement*> all;
    const std::vector<Measurement>& made = measurements_.made();
    for (std::size_t i = hidden_; i < made.size(); ++i) all.push_back(&made[i]);
    if (measurements_.half_made()) all.push_back(measurements_.half_made());
    return all;
}

void ViewRuler::find_anchors(const std::vector<Vec3>& rest) {
    if (anchored_to_ == &rest) return;
    anchored_to_ = &rest;
    anchors_.clear();
    for (const Measurement* measurement : drawn())
        for (const Vec3& point : measurement->points_mm)
            anchors_.push_back(nearest_vertex(rest, point, reach_mm));
}

void ViewRuler::click(const SurfacePick& pick, const ViewAxes& axes) {
    const Frame* frame = screen_.frame();
    if (!patient_ || !frame || pick.triangle < 0) return;
    const std::vector<Vec3>& rest = rest_vertices(*patient_, *frame);
    Vec3 place = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const int vertex = frame->origin_of(pick.vertices[i]);
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= rest.size()) return;
        place += pick.weights[i] * rest[static_cast<std::size_t>(vertex)];
    }
    const std::string told =
        measurements_.add_point(place, SlicePlane{axes.forward, axes.right}, patient_->tree);
    screen_.say(told.empty() ? guidance().toStdString() : told);
}

void ViewRuler::follow() {
    const Frame* frame = screen_.frame();
    std::vector<MeasureView> views;
    if (patient_ && frame) {
        const std::vector<Vec3>& rest = rest_vertices(*patient_, *frame);
        find_anchors(rest);
        std::size_t next = 0;
        for (const Measurement* measurement : drawn()) {
            MeasureView view{measurement->points_mm, measurement->text};
            bool moved = false;
            for (Vec3& point : view.points_mm) {
                const Vec3 by = displacement_mm(anchors_[next++], rest, *frame);
                moved |= by.norm() > moved_mm;
                point += by;
            }
            if (moved && !view.text.empty())
                view.text =
                    Words::tr("%1 (at rest)").arg(QString::fromStdString(view.text)).toStdString();
            views.push_back(std::move(view));
        }
    }
    screen_.show(std::move(views));
}

QString ViewRuler::guidance() const {
    if (!measurements_.chosen()) return {};
    const Measurement* half = measurements_.half_made();
    const std::size_t points = half ? half->points_mm.size() : 0;
    switch (*measurements_.chosen()) {
        case MeasurementKind::distance:
            return points == 0
                       ? Words::tr(
                             "Click where the distance begins: on a vessel, or anywhere in a slice")
                       : Words::tr("Click where it ends");
        case MeasurementKind::angle:
            return points == 0
                       ? Words::tr(
                             "Click on one arm of the angle: on a vessel, or anywhere in a slice")
                   : points == 1 ? Words::tr("Click on its vertex")
                                 : Words::tr("Click on the other arm");
        case MeasurementKind::diameter:
            return Words::tr(
                "Click on a vessel: its diameter there, and the stenosis against the vessel "
                "beside");
    }
    return {};
}

}  // namespace hepatica
