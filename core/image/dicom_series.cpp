// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of size, orientation, spacing, tilt and gaps, each with an error that names the file.
#include "core/image/dicom_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/quoted_name.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr double axis_tolerance = 1e-3;  // of a direction cosine, between slices
constexpr double same_place_mm = 1e-3;
constexpr double gap_tolerance = 0.1;  // in slice spacings; positions are rounded
// How far a slice may lie from its place on the even grid, in slice spacings. Up to there each is
// nearest to its own place, and rounding stays far below, because it does not add up: positions
// rounded to 0.1 mm lie within 0.1 mm of their places (0.05 mm of their own and 0.05 mm of the
// ends), those of three decimals within 0.001 mm. That is a tenth of a spacing of 1 mm; finer ones
// that are no whole tenths make gaps that are uneven already.
constexpr double place_tolerance = 0.5;
constexpr double sideways_tolerance = 0.2;  // in pixels
constexpr double tilt_tolerance_degrees = 0.1;
constexpr double largest_tilt_degrees = 45.0;  // gantries tilt by up to 30 degrees

const std::string remedy = "Export the series again, complete, as axial slices of one size";

[[noreturn]] void reject(const DicomSlice& slice, const std::string& what) {
    throw InputError(what, slice.file.string(), remedy);
}

std::string short_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string millimetres(double value) {
    return short_text(value) + " mm";
}

void require_same_frame(const DicomSlice& slice, const DicomSlice& first) {
    if (slice.rows != first.rows || slice.columns != first.columns)
        reject(slice, "has " + std::to_string(slice.columns) + " x " + std::to_string(slice.rows) +
                          " pixels, but " + quoted_name(first.file.filename().string()) + " has " +
                          std::to_string(first.columns) + " x " + std::to_string(first.rows));
    if ((slice.row_axis - first.row_axis).norm() > axis_tolerance ||
        (slice.column_axis - first.column_axis).norm() > axis_tolerance)
        reject(slice, "is oriented otherwise than " + quoted_name(first.file.filename().string()));
    if (std::abs(slice.row_spacing_mm - first.row_spacing_mm) > 1e-3 * first.row_spacing_mm ||
        std::abs(slice.column_spacing_mm - first.column_spacing_mm) >
            1e-3 * first.column_spacing_mm)
        reject(slice, "has pixels of " + millimetres(slice.column_spacing_mm) + ", but " +
                          quoted_name(first.file.filename().string()) + " of " +
                          millimetres(first.column_spacing_mm));
}

void require_sound_slice(const DicomSlice& slice) {
    if (slice.frames > 1)
        reject(slice, "holds " + std::to_string(slice.frames) +
                          " frames in one file and is no enhanced CT, the only kind of many frames "
                          "that this program reads");
    if (!slice.problem.empty()) reject(slice, slice.problem);
    if (!slice.has_geometry) reject(slice, "has no position, orientation or pixel spacing");
    const auto is_unit = [](const Vec3& v) { return std::abs(v.norm() - 1.0) < 1e-2; };
    if (!is_unit(slice.row_axis) || !is_unit(slice.column_axis) ||
        std::abs(slice.row_axis.dot(slice.column_axis)) > 1e-2)
        reject(slice, "has an orientation that is no pair of perpendicular directions");
    if (!(slice.row_spacing_mm > 0.0) || !(slice.column_spacing_mm > 0.0))
        reject(slice, "has a pixel spacing of " + millimetres(slice.row_spacing_mm));
}

double sideways_mm(const DicomSlice& slice, const Vec3& from, const Vec3& along) {
    const Vec3 offset = slice.position_mm - from;
    return (offset - along * along.dot(offset)).norm();
}

// The tilt of the gantry in degrees; 0 if it shifts the slices by less than a pixel in total. Every
// slice must lie on the line from the first to the last.
double tilt_of_stack(const std::vector<DicomSlice>& slices) {
    const DicomSlice& first = slices.front();
    const Vec3 stack = (slices.back().position_mm - first.position_mm).normalized();
    const double cosine = std::min(1.0, std::abs(stack.dot(first.normal())));
    const double degrees = std::acos(cosine) * 180.0 / std::numbers::pi;
    const double pixel_mm = std::min(first.row_spacing_mm, first.column_spacing_mm);
    const double drift_mm = sideways_mm(slices.back(), first.position_mm, first.normal());
    if (degrees > largest_tilt_degrees)
        throw InputError("its slices are stacked aslant by " + short_text(degrees) +
                             " degrees, which is more than any gantry tilts",
                         first.file.parent_path().string(),
                         "Ask for the series reformatted to straight axial slices");
    for (const DicomSlice& slice : slices)
        if (sideways_mm(slice, first.position_mm, stack) > sideways_tolerance * pixel_mm)
            reject(slice, "is shifted sideways by " +
                              millimetres(sideways_mm(slice, first.position_mm, stack)));
    return degrees > tilt_tolerance_degrees && drift_mm > pixel_mm ? degrees : 0.0;
}

double median_gap_mm(const std::vector<DicomSlice>& slices) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < slices.size(); ++i)
        gaps.push_back(slices[i].along_normal_mm() - slices[i - 1].along_normal_mm());
    return median(std::move(gaps));
}

void require_even_gaps(const std::vector<DicomSlice>& slices) {
    const double usual_mm = median_gap_mm(slices);
    for (std::size_t i = 1; i < slices.size(); ++i) {
        const double gap_mm = slices[i].along_normal_mm() - slices[i - 1].along_normal_mm();
        if (std::abs(gap_mm - usual_mm) <= gap_tolerance * usual_mm) continue;
        const std::string where = "between " + quoted_name(slices[i - 1].file.filename().string()) +
                                  " and " + quoted_name(slices[i].file.filename().string());
        const double missing = gap_mm / usual_mm - 1.0;
        const long whole = std::lround(missing);
        if (whole >= 1 && std::abs(missing - static_cast<double>(whole)) <= gap_tolerance)
            throw InputError(std::to_string(whole) +
                                 (whole == 1 ? " slice is missing " : " slices are missing ") +
                                 where + " (at " + millimetres(slices[i - 1].along_normal_mm()) +
                                 " to " + millimetres(slices[i].along_normal_mm()) + ")",
                             slices[i].file.string(), remedy);
        throw InputError("the gap " + where + " is " + millimetres(gap_mm) + ", elsewhere it is " +
                             millimetres(usual_mm),
                         slices[i].file.string(), remedy);
    }
}

// Gaps that differ by less than their tolerance may still add up: 150 gaps of 1 mm and then 150 of
// 1.05 mm would put slices up to 3.7 mm beside their places.
void require_even_places(const std::vector<DicomSlice>& slices) {
    const Vec3 normal = slices.front().normal();
    std::vector<double> levels_mm;
    std::vector<std::int64_t> places;
    for (const DicomSlice& slice : slices) {
        levels_mm.push_back(slice.position_mm.dot(normal));
        places.push_back(static_cast<std::int64_t>(places.size()));
    }
    const std::optional<std::size_t> astray = furthest_astray(levels_mm, places);
    if (!astray) return;
    const std::size_t last = levels_mm.size() - 1;
    const double mean_mm = (levels_mm[last] - levels_mm[0]) / static_cast<double>(last);
    const double before_mm = (levels_mm[*astray] - levels_mm[0]) / static_cast<double>(*astray);
    throw InputError("lies where the distance between slices changes: it is " +
                         millimetres(before_mm) + " on average up to there, and " +
                         millimetres(mean_mm) + " in the whole series",
                     slices[*astray].file.string(), remedy);
}

}  // namespace

std::optional<std::size_t> furthest_astray(std::span<const double> levels_mm,
                                           std::span<const std::int64_t> places) {
    if (places.empty() || places.back() < 1) return std::nullopt;
    const double step_mm =
        (levels_mm.back() - levels_mm.front()) / static_cast<double>(places.back());
    std::optional<std::size_t> furthest;
    double most_mm = place_tolerance * step_mm;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double place_mm = levels_mm.front() + step_mm * static_cast<double>(places[i]);
        const double astray_mm = std::abs(levels_mm[i] - place_mm);
        if (astray_mm <= most_mm) continue;
        most_mm = astray_mm;
        furthest = i;
    }
    return furthest;
}

void require_one_shape(const std::vector<DicomSlice>& slices) {
    for (const DicomSlice& slice : slices) {
        require_sound_slice(slice);
        require_same_frame(slice, slices.front());
    }
}

OrderedSeries order_slices(std::vector<DicomSlice> series) {
    require_one_shape(series);
    const Vec3 normal = series.front().normal();
    std::ranges::stable_sort(
        series, {}, [&](const DicomSlice& slice) { return slice.position_mm.dot(normal); });
    OrderedSeries ordered;
    for (DicomSlice& slice : series) {
        const bool repeats =
            !ordered.slices.empty() &&
            std::abs((slice.position_mm - ordered.slices.back().position_mm).dot(normal)) <
                same_place_mm;
        if (repeats)
            ordered.repeated.emplace_back(ordered.slices.size() - 1, std::move(slice));
        else
            ordered.slices.push_back(std::move(slice));
    }
    if (ordered.slices.size() < 2)
        throw InputError("its series has only one slice", ordered.slices.front().file.string(),
                         remedy);
    ordered.tilt_degrees = tilt_of_stack(ordered.slices);
    require_even_gaps(ordered.slices);
    require_even_places(ordered.slices);
    ordered.slice_spacing_mm =
        (ordered.slices.back().along_normal_mm() - ordered.slices.front().along_normal_mm()) /
        static_cast<double>(ordered.slices.size() - 1);
    return ordered;
}

}  // namespace hepatica
