// SPDX-License-Identifier: GPL-3.0-or-later
// Orders the frames of all segments by their position along the normal and merges them into one
// label map.
#include "core/image/dicom_segmentation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/dicom_frames.h"
#include "core/image/dicom_reader.h"
#include "core/image/dicom_series.h"
#include "core/image/memory_limit.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr double same_level_mm = 1e-3;
constexpr double uneven = 0.1;  // in steps; positions are rounded
// How far a slice may lie off the normal through the first, in pixels.
constexpr double sideways_of_pixel = 0.2;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Export the segmentation as NIfTI or NRRD");
}

std::string in_mm(double value) {
    std::ostringstream text;
    text.precision(4);
    text << value << " mm";
    return text.str();
}

// Distances along the normal at which there are slices, ascending, without repeats.
std::vector<double> levels_of(const std::vector<DicomSlice>& frames) {
    std::vector<double> levels, once;
    for (const DicomSlice& frame : frames)
        levels.push_back(frame.position_mm.dot(frames.front().normal()));
    std::ranges::sort(levels);
    for (const double level : levels)
        if (once.empty() || level - once.back() > same_level_mm) once.push_back(level);
    return once;
}

// The first gap that is not a whole multiple of the step.
std::optional<double> odd_gap_mm(const std::vector<double>& levels, double step_mm) {
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const double gap_mm = levels[i] - levels[i - 1];
        const double steps = std::round(gap_mm / step_mm);
        if (steps < 1.0 || std::abs(gap_mm - steps * step_mm) > uneven * step_mm) return gap_mm;
    }
    return std::nullopt;
}

// The step between slices: the stated spacing if all gaps are whole multiples of it, because slices
// without any segment may be missing; else the smallest gap.
double step_of(const std::vector<double>& levels, double stated_mm, const fs::path& file) {
    if (stated_mm > 0.0 && !odd_gap_mm(levels, stated_mm)) return stated_mm;
    if (levels.size() < 2) refuse(file, "has one slice and no spacing of slices (0018,0088)");
    double least_mm = levels[1] - levels[0];
    for (std::size_t i = 2; i < levels.size(); ++i)
        least_mm = std::min(least_mm, levels[i] - levels[i - 1]);
    if (const auto odd_mm = odd_gap_mm(levels, least_mm))
        refuse(file, "has slices " + in_mm(*odd_mm) + " apart where " + in_mm(least_mm) +
                         " lie between others");
    return least_mm;
}

void require_upright(const std::vector<DicomSlice>& frames) {
    const DicomSlice& first = frames.front();
    const double pixel_mm = std::min(first.row_spacing_mm, first.column_spacing_mm);
    for (const DicomSlice& frame : frames) {
        const Vec3 offset = frame.position_mm - first.position_mm;
        const double aside_mm = (offset - first.normal() * first.normal().dot(offset)).norm();
        if (aside_mm > sideways_of_pixel * pixel_mm)
            refuse(frame.file, "lies " + in_mm(aside_mm) +
                                   " beside the first frame: the segmentation of a series that a "
                                   "tilted gantry has sheared is not read");
    }
}

// Each level's number of steps from the first. Counted gap by gap: the step may be a tenth beside
// the true one, and over the whole extent that would add up to slices more or fewer.
std::vector<std::int64_t> places_of(const std::vector<double>& levels, double step_mm) {
    std::vector<std::int64_t> places{0};
    double steps = 0.0;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        steps += std::round((levels[i] - levels[i - 1]) / step_mm);
        places.push_back(std::llround(steps));
    }
    return places;
}

struct Place {
    PlacedGrid placed;
    double first_level_mm = 0.0;
    double step_mm = 0.0;
};

Place place_of(const std::vector<DicomSlice>& frames, const fs::path& file) {
    const DicomSlice& first = frames.front();
    const Vec3 normal = first.normal();
    const std::vector<double> levels = levels_of(frames);
    double step_mm = step_of(levels, first.stated_spacing_mm, file);
    const double extent_mm = levels.back() - levels.front();
    const std::vector<std::int64_t> places = places_of(levels, step_mm);
    const std::int64_t steps = places.back();
    if (steps > 0) step_mm = extent_mm / static_cast<double>(steps);
    if (const auto astray = furthest_astray(levels, places))
        refuse(file, "has slices whose distance changes: slice " +
                         std::to_string(places[*astray] + 1) +
                         " lies more than half a step from its place");
    const Vec3 origin_mm =
        first.position_mm + normal * (levels.front() - first.position_mm.dot(normal));
    require_memory(bytes_of(first.columns, first.rows, steps + 1, sizeof(std::uint16_t)),
                   file.string());
    return {placed_grid({first.columns, first.rows, steps + 1}, first.steps_mm(step_mm), origin_mm,
                        file.string()),
            levels.front(), step_mm};
}

// The level is measured along the normal of the first frame, as those of the place are.
void add_frame(LabelMap& labels, const Place& place, const Vec3& normal, const DicomSlice& frame,
               const std::function<bool(int)>& wanted) {
    const double level_mm = frame.position_mm.dot(normal);
    const auto z = std::lround((level_mm - place.first_level_mm) / place.step_mm);
    const auto& strides = place.placed.strides;
    const std::vector<double> values = read_pixels(frame);
    std::size_t i = 0;
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.columns; ++x, ++i) {
            const auto label = static_cast<std::uint16_t>(values[i]);
            if (label == 0 || !wanted(label)) continue;
            std::uint16_t& voxel =
                labels
                    .voxels[place.placed.first + x * strides[0] + y * strides[1] + z * strides[2]];
            voxel = std::max(voxel, label);
        }
}

}  // namespace

bool is_dicom_segmentation(const fs::path& file) {
    if (!is_dicom_file(file)) return false;
    const std::optional<DicomSlice> slice = read_dicom_slice(file);
    return slice && slice->segmentation;
}

LabelMap read_dicom_segmentation(const fs::path& file, const std::function<bool(int label)>& wanted,
                                 Job& job) {
    const std::optional<DicomSlice> whole = read_dicom_slice(file);
    if (!whole) refuse(file, "is no DICOM image");
    SplitFrames split;
    const std::vector<DicomSlice> frames = split.split({*whole}, job);
    require_one_shape(frames);
    require_upright(frames);
    const Place place = place_of(frames, file);
    LabelMap labels(place.placed.grid);
    const Vec3 normal = frames.front().normal();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        job.advance(static_cast<double>(i) / static_cast<double>(frames.size()));
        add_frame(labels, place, normal, frames[i], wanted);
    }
    return labels;
}

}  // namespace hepatica
