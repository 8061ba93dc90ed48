// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/measurements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tree/lumen_calibre.h"
#include "core/tree/station.h"
#include "ui/words.h"

namespace hepatica {
namespace {

std::string formatted(const QString& format, double value, int decimals) {
    return format.arg(value, 0, 'f', decimals).toStdString();
}

double angle_deg(const Vec3& a, const Vec3& vertex, const Vec3& b) {
    const Vec3 u = a - vertex, v = b - vertex;
    return std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::numbers::pi;
}

std::string text_of(const KeptMeasurement& measurement) {
    const auto& points = measurement.points_mm;
    if (measurement.kind == MeasurementKind::angle)
        return formatted("%L1\u00b0", angle_deg(points[0], points[1], points[2]), 0);
    const double length_mm = (points[1] - points[0]).norm();
    if (measurement.kind == MeasurementKind::distance) return formatted("%L1 mm", length_mm, 1);
    std::string text = formatted("\u2300 %L1 mm", length_mm, 1);
    if (!measurement.stenosis) return text;
    const double percent = std::round(100.0 * *measurement.stenosis);
    return text +
           formatted(percent < 0.0 ? Words::tr(", %L1 % wider") : Words::tr(", stenosis %L1 %"),
                     std::abs(percent), 0);
}

// Unit vector across the vessel within the slice; `plane.right` where the vessel is nearly
// perpendicular to the slice.
Vec3 across(const VesselSegment& segment, double arclength_mm, const SlicePlane& plane) {
    constexpr double reach_mm = 1.0;
    const Vec3 along = station_at(segment, arclength_mm + reach_mm).position_mm -
                       station_at(segment, arclength_mm - reach_mm).position_mm;
    const Vec3 direction = plane.normal.cross(along);
    constexpr double nearly_through = 0.1;
    if (direction.norm() > nearly_through * along.norm()) return direction.normalized();
    return plane.right;
}

KeptMeasurement diameter_of(const LumenCalibre& calibre, const Vec3& direction) {
    const Vec3 half = 0.5 * calibre.diameter_mm * direction;
    return {MeasurementKind::diameter,
            {calibre.position_mm - half, calibre.position_mm + half},
            calibre.stenosis};
}

bool nearly_same(const KeptMeasurement& a, const KeptMeasurement& b) {
    constexpr double rounding = 1e-6;  // mm, and of a share
    return (a.points_mm[0] - b.points_mm[0]).norm() < rounding &&
           (a.points_mm[1] - b.points_mm[1]).norm() < rounding &&
           a.stenosis.has_value() == b.stenosis.has_value() &&
           std::abs(a.stenosis.value_or(0.0) - b.stenosis.value_or(0.0)) < rounding;
}

// As it is on this tree. The same vessel gives the very same numbers; nothing where there is none.
std::optional<KeptMeasurement> taken_anew(const KeptMeasurement& taken, const VesselTree& tree) {
    if (taken.kind != MeasurementKind::diameter) return taken;
    const Vec3 &from = taken.points_mm[0], &to = taken.points_mm[1];
    const auto calibre = calibre_at(tree, 0.5 * (from + to));
    if (!calibre) return std::nullopt;
    KeptMeasurement now = diameter_of(*calibre, (to - from).normalized());
    return nearly_same(now, taken) ? taken : now;
}

const KeptMeasurement& as_kept(const Measurement& made) {
    return made;
}

}  // namespace

void Measurements::choose(std::optional<MeasurementKind> kind) {
    kind_ = kind;
    half_made_ = {};
    tell();
}

std::string Measurements::add_point(const Vec3& position_mm, const SlicePlane& plane,
                                    const VesselTree& tree) {
    if (!kind_) return {};
    if (*kind_ == MeasurementKind::diameter) return add_diameter(position_mm, plane, tree);
    half_made_.kind = *kind_;
    half_made_.points_mm.push_back(position_mm);
    const std::size_t needed = *kind_ == MeasurementKind::angle ? 3 : 2;
    std::string told;
    if (half_made_.points_mm.size() == needed) {
        told = half_made_.text = text_of(half_made_);
        finish();
    }
    tell();
    return told;
}

std::string Measurements::add_diameter(const Vec3& position_mm, const SlicePlane& plane,
                                       const VesselTree& tree) {
    const auto calibre = calibre_at(tree, position_mm);
    if (!calibre)
        return Words::tr("There is no vessel. Click on one, or measure a distance").toStdString();
    const auto& segment = tree.segments[static_cast<std::size_t>(calibre->segment)];
    const KeptMeasurement diameter =
        diameter_of(*calibre, across(segment, calibre->arclength_mm, plane));
    const std::string text = text_of(diameter);
    half_made_ = {diameter, text};
    finish();
    tell();
    // This note is too long to stand beside the vessel.
    return calibre->stenosis ? text
                             : Words::tr(
                                   "%1; a stenosis is judged where the vessel goes on for 10 mm to "
                                   "both sides")
                                   .arg(QString::fromStdString(text))
                                   .toStdString();
}

void Measurements::finish() {
    places_.push_back(taken_.size());
    taken_.push_back(half_made_);
    made_.push_back(std::move(half_made_));
    half_made_ = {};
    on_work_();
}

void Measurements::remove_last() {
    if (!half_made_.points_mm.empty()) {
        half_made_.points_mm.pop_back();
    } else if (!made_.empty()) {
        taken_.erase(taken_.begin() + static_cast<std::ptrdiff_t>(places_.back()));
        made_.pop_back();
        places_.pop_back();
        on_work_();
    }
    tell();
}

std::vector<KeptMeasurement> Measurements::kept() const {
    std::vector<KeptMeasurement> all = taken_;
    for (std::size_t i = 0; i < made_.size(); ++i) all[places_[i]] = made_[i];
    return all;
}

std::vector<KeptMeasurement> Measurements::remove_all() {
    std::vector<KeptMeasurement> removed = std::move(taken_);
    clear();
    on_work_();
    return removed;
}

void Measurements::bring_back(std::vector<KeptMeasurement> removed, const VesselTree& tree) {
    removed.insert(removed.end(), taken_.begin(), taken_.end());
    taken_ = std::move(removed);
    show_on(tree);
    on_work_();
    tell();
}

void Measurements::show_on(const VesselTree& tree) {
    made_.clear();
    places_.clear();
    for (std::size_t i = 0; i < taken_.size(); ++i) {
        const auto now = taken_anew(taken_[i], tree);
        if (!now) continue;
        made_.push_back({*now, text_of(*now)});
        places_.push_back(i);
    }
}

std::size_t Measurements::follow_tree(const VesselTree& tree) {
    const std::vector<KeptMeasurement> before(made_.begin(), made_.end());
    show_on(tree);
    if (std::ranges::equal(before, made_, {}, {}, as_kept)) return 0;
    on_work_();
    tell();
    return before.size() > made_.size() ? before.size() - made_.size() : 0;
}

std::size_t Measurements::show(std::vector<KeptMeasurement> measurements, const VesselTree& tree) {
    half_made_ = {};
    taken_ = std::move(measurements);
    show_on(tree);
    tell();
    return taken_.size() - made_.size();
}

void Measurements::clear() {
    half_made_ = {};
    taken_.clear();
    made_.clear();
    places_.clear();
    tell();
}

void Measurements::tell() const {
    for (const auto& watcher : watchers_) watcher();
}

}  // namespace hepatica
