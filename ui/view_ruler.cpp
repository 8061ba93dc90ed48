// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view_ruler.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "ui/words.h"

namespace hepatica {
namespace {

// A point of a slice that is farther from all vessels does not move with one.
constexpr double reach_mm = 10.0;
// A smaller displacement counts as at rest.
constexpr double moved_mm = 0.5;

int nearest_vertex(const std::vector<Vec3>& vertices_mm, const Vec3& point_mm) {
    int nearest = -1;
    double least = reach_mm * reach_mm;
    for (std::size_t v = 0; v < vertices_mm.size(); ++v) {
        const double square = (vertices_mm[v] - point_mm).squaredNorm();
        if (square >= least) continue;
        least = square;
        nearest = static_cast<int>(v);
    }
    return nearest;
}

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

// In a scene without deformation frames hold the surface's vertices, not the body's.
const std::vector<Vec3>& ViewRuler::rest_of(const Frame& frame) const {
    const std::vector<Vec3>& body = patient_->mesh.vertices_mm;
    const bool moves = !body.empty() && frame.positions_mm.size() >= 3 * body.size();
    return moves ? body : patient_->surface.vertices_mm;
}

void ViewRuler::find_anchors(const std::vector<Vec3>& rest) {
    if (anchored_to_ == &rest) return;
    anchored_to_ = &rest;
    anchors_.clear();
    for (const Measurement* measurement : drawn())
        for (const Vec3& point : measurement->points_mm)
            anchors_.push_back(nearest_vertex(rest, point));
}

void ViewRuler::click(const SurfacePick& pick, const ViewAxes& axes) {
    const Frame* frame = screen_.frame();
    if (!patient_ || !frame || pick.triangle < 0) return;
    const std::vector<Vec3>& rest = rest_of(*frame);
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
        const std::vector<Vec3>& rest = rest_of(*frame);
        find_anchors(rest);
        std::size_t next = 0;
        for (const Measurement* measurement : drawn()) {
            MeasureView view{measurement->points_mm, measurement->text};
            bool moved = false;
            for (Vec3& point : view.points_mm) {
                const int anchor = anchors_[next++];
                if (anchor < 0) continue;
                const auto v = static_cast<std::size_t>(anchor);
                if (3 * v + 2 >= frame->positions_mm.size()) continue;
                const float* at = &frame->positions_mm[3 * v];
                const Vec3 by = Vec3(at[0], at[1], at[2]) - rest[v];
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
