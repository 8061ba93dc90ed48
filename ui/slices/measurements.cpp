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

std::string text_of(const Measurement& measurement) {
    const auto& points = measurement.points_mm;
    if (measurement.kind == MeasurementKind::angle)
        return formatted("%L1\u00b0", angle_deg(points[0], points[1], points[2]), 0);
    return formatted("%L1 mm", (points[1] - points[0]).norm(), 1);
}

std::string text_of(const LumenCalibre& calibre) {
    std::string text = formatted("\u2300 %L1 mm", calibre.diameter_mm, 1);
    if (!calibre.stenosis) return text;
    const double percent = std::round(100.0 * *calibre.stenosis);
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
    const Vec3 half = 0.5 * calibre->diameter_mm * across(segment, calibre->arclength_mm, plane);
    const std::string text = text_of(*calibre);
    half_made_ = {MeasurementKind::diameter,
                  {calibre->position_mm - half, calibre->position_mm + half},
                  text};
    finish();
    tell();
    // This note is too long to stand beside the vessel.
    return calibre->stenosis ? text
                             : Words::tr("%1, too near its end to judge a stenosis")
                                   .arg(QString::fromStdString(text))
                                   .toStdString();
}

void Measurements::finish() {
    made_.push_back(std::move(half_made_));
    half_made_ = {};
}

void Measurements::remove_last() {
    if (!half_made_.points_mm.empty())
        half_made_ = {};
    else if (!made_.empty())
        made_.pop_back();
    tell();
}

void Measurements::remove_diameters() {
    std::erase_if(made_, [](const Measurement& measurement) {
        return measurement.kind == MeasurementKind::diameter;
    });
    tell();
}

void Measurements::clear() {
    half_made_ = {};
    made_.clear();
    tell();
}

void Measurements::tell() const {
    for (const auto& watcher : watchers_) watcher();
}

}  // namespace hepatica
