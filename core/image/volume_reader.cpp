// SPDX-License-Identifier: GPL-3.0-or-later
// Dispatch by file format, conversion to the type of voxel, and the checks of masks and CTs.
#include "core/image/volume_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/dicom_header.h"
#include "core/image/dicom_reader.h"
#include "core/image/dicom_segmentation.h"
#include "core/image/filters.h"
#include "core/image/header_text.h"
#include "core/image/hounsfield.h"
#include "core/image/series_choice.h"
#include "core/image/voxel_file.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::int16_t air_hu = -1024;

void require_existing(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::status_known(status))  // a folder above it may not be entered, for example
        throw InputError("cannot be opened (" + error.message() + ")", path.string(),
                         "Check that it exists and may be read");
    if (!fs::exists(status)) throw InputError("does not exist", path.string(), "Check the path");
}

// Sets each voxel marked in `missing` to the mean of its neighbours if at least half of them have
// values; returns the number of voxels set. Scattered holes are damage, large ones are padding
// around the scan.
std::size_t fill_from_neighbours(Volume& volume, const std::vector<std::uint8_t>& missing,
                                 const Job& job) {
    std::size_t filled = 0;
    for (std::size_t hole = 0; hole < missing.size(); ++hole) {
        if (hole % 65536 == 0) job.throw_if_cancelled();
        if (missing[hole] == 0) continue;
        const auto [x, y, z] = volume.grid.index_of(hole);
        int inside = 0, there = 0;
        double sum = 0.0;
        for (int i = 0; i < 27; ++i) {
            const int nx = x + i % 3 - 1, ny = y + i / 3 % 3 - 1, nz = z + i / 9 - 1;
            if (!volume.grid.contains(nx, ny, nz)) continue;
            ++inside;
            const std::size_t neighbour = volume.grid.offset(nx, ny, nz);
            if (missing[neighbour] != 0) continue;
            ++there;
            sum += volume.voxels[neighbour];
        }
        if (2 * there < inside) continue;
        volume.voxels[hole] = static_cast<std::int16_t>(std::lround(sum / there));
        ++filled;
    }
    return filled;
}

Volume read_volume_file(const fs::path& path, Job& job, ReadRemarks& remarks) {
    const VoxelFile file = read_header(path);
    require_affordable(file, sizeof(std::int16_t));
    const PlacedGrid placed = placed_grid(file.dims, file.axes, file.origin_mm, path.string());
    if (file.orientation_assumed)
        remarks.push_back(
            "The file does not say how the patient lies in it (its qform and sform codes are 0): "
            "its axes were taken to lead to his right, front and head. Compare the sides in the "
            "slices");
    Volume volume = filled_image(placed.grid, std::int16_t{0}, job);
    std::size_t not_numbers = 0;
    std::vector<std::uint8_t> missing;  // empty if every value is a number
    std::size_t clamped = 0;
    read_values(
        file, placed,
        [&](std::ptrdiff_t at, std::ptrdiff_t step, std::span<const double> values) {
            for (double value : values) {
                if (!std::isfinite(value)) {
                    if (missing.empty()) missing.resize(volume.voxels.size(), 0);
                    missing[static_cast<std::size_t>(at)] = 1;
                    ++not_numbers;
                    value = air_hu;
                }
                if (!fits_hounsfield(value)) ++clamped;
                volume.voxels[at] = nearest_hounsfield(value);
                at += step;
            }
        },
        job);
    if (not_numbers > 0) {
        const std::size_t filled = fill_from_neighbours(volume, missing, job);
        remarks.push_back(std::to_string(not_numbers) + " of " +
                          std::to_string(volume.voxels.size()) +
                          " values are not numbers (NaN or infinite): " + std::to_string(filled) +
                          " became the mean of their neighbours, the others air");
    }
    if (clamped > 0) remarks.push_back(remark_on_clamped(clamped));
    return volume;
}

bool is_dicom(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) || lower_case(path.filename().string()) == "dicomdir" ||
           is_dicom_file(path);
}

Volume read_dicom_at(const fs::path& path, DicomWish wish, Job& job, ReadRemarks& remarks) {
    const DicomPlace place = dicom_place(path);
    wish.series.member = place.member;
    return read_dicom(place.folder, wish, job, remarks);
}

// Tells which values belong to a mask.
class Wanted {
  public:
    explicit Wanted(std::span<const int> labels) : labels_(labels) {}
    bool operator()(double value) const {
        if (labels_.empty()) return value != 0.0 && !std::isnan(value);
        return std::ranges::find(labels_, value) != labels_.end();
    }

  private:
    std::span<const int> labels_;
};

void require_object(const Mask& mask, const fs::path& path) {
    if (std::ranges::any_of(mask.voxels, [](std::uint8_t v) { return v != 0; })) return;
    throw InputError("marks no voxel", path.string(),
                     "Choose a mask that is not empty, or another label of it");
}

void require_whole_label(double value, const fs::path& file) {
    if (value >= 0.0 && value <= 65535.0 && value == std::floor(value)) return;
    throw InputError("holds the value " + number_text(value) + ", which is no label", file.string(),
                     "Choose a mask or label map, not an image");
}

}  // namespace

Volume read_volume(const fs::path& path, Job& job, ReadRemarks* remarks, int series) {
    require_existing(path);
    job.begin_stage("Reading the images");
    ReadRemarks unheard;
    ReadRemarks& heard = remarks != nullptr ? *remarks : unheard;
    if (is_dicom(path))
        return read_dicom_at(path, {{{}, series}, air_hu, BetweenPixels::linear}, job, heard);
    if (series != 0)
        throw InputError("is one image and holds no series", path.string(),
                         "Leave --series out, or give a DICOM folder");
    return read_volume_file(path, job, heard);
}

std::vector<SeriesDescription> list_series(const fs::path& folder, Job& job) {
    require_existing(folder);
    job.begin_stage("Looking for images");
    ReadRemarks unheard;
    return describe_series(find_dicom_slices(folder, job, unheard));
}

LabelMap read_label_map(const fs::path& path, Job& job) {
    require_existing(path);
    job.begin_stage("Reading the label map");
    if (is_dicom_segmentation(path))
        return read_dicom_segmentation(
            path, [](int) { return true; }, job);
    const VoxelFile file = read_header(path);
    require_affordable(file, sizeof(std::uint16_t));
    const PlacedGrid placed = placed_grid(file.dims, file.axes, file.origin_mm, path.string());
    LabelMap labels = filled_image(placed.grid, std::uint16_t{0}, job);
    read_values(
        file, placed,
        [&](std::ptrdiff_t at, std::ptrdiff_t step, std::span<const double> values) {
            for (const double value : values) {
                require_whole_label(value, path);
                labels.voxels[at] = static_cast<std::uint16_t>(value);
                at += step;
            }
        },
        job);
    return labels;
}

Mask narrow_labels(const LabelMap& labels, const std::string& place) {
    Mask mask(labels.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const std::uint16_t label = labels.voxels[i];
        if (label > 255)
            throw InputError("holds label " + std::to_string(label), place,
                             "Labels of a mask go from 1 to 255: give it others, or name those "
                             "that are vessels (--vessel-label)");
        mask.voxels[i] = static_cast<std::uint8_t>(label);
    }
    return mask;
}

Mask read_mask(const fs::path& path, Job& job, std::span<const int> labels) {
    require_existing(path);
    job.begin_stage("Reading the mask");
    const Wanted wanted(labels);
    Mask mask;
    if (is_dicom_segmentation(path)) {
        const LabelMap segments = read_dicom_segmentation(path, wanted, job);
        mask = Mask(segments.grid);
        std::ranges::transform(segments.voxels, mask.voxels.begin(), [](std::uint16_t label) {
            return static_cast<std::uint8_t>(label != 0 ? 1 : 0);
        });
    } else if (is_dicom(path)) {
        ReadRemarks unheard;
        const Volume volume =
            read_dicom_at(path, {{{}, 0}, 0, BetweenPixels::nearest}, job, unheard);
        mask = Mask(volume.grid);
        std::ranges::transform(volume.voxels, mask.voxels.begin(), [&](std::int16_t value) {
            return static_cast<std::uint8_t>(wanted(value) ? 1 : 0);
        });
    } else {
        const VoxelFile file = read_header(path);
        require_affordable(file, sizeof(std::uint8_t));
        const PlacedGrid placed = placed_grid(file.dims, file.axes, file.origin_mm, path.string());
        mask = filled_image(placed.grid, std::uint8_t{0}, job);
        read_values(
            file, placed,
            [&](std::ptrdiff_t at, std::ptrdiff_t step, std::span<const double> values) {
                for (const double value : values) {
                    mask.voxels[at] = wanted(value) ? 1 : 0;
                    at += step;
                }
            },
            job);
    }
    require_object(mask, path);
    return mask;
}

void require_same_grid(const Grid& mask, const Grid& volume, const std::string& place) {
    if (same_grid(mask, volume)) return;
    const auto sizes = [](const Grid& g) {
        return std::to_string(g.dims[0]) + " x " + std::to_string(g.dims[1]) + " x " +
               std::to_string(g.dims[2]);
    };
    const std::string problem =
        mask.dims == volume.dims
            ? "the mask lies elsewhere in space than the CT"
            : "the mask has " + sizes(mask) + " voxels, but the CT has " + sizes(volume);
    throw InputError(problem, place, "Choose a mask that was drawn on this CT");
}

namespace {

// The index at which a grid begins in another with the same voxels; nothing if it does not lie in
// it.
std::optional<Index3> place_in(const Grid& volume, const Grid& box) {
    Grid corner = volume;
    corner.dims = box.dims;
    const Vec3 start = volume.to_index(box.origin_mm);
    Index3 place{};
    for (int a = 0; a < 3; ++a) {
        place[a] = static_cast<int>(std::lround(start[a]));
        if (place[a] < 0 || place[a] + box.dims[a] > volume.dims[a]) return std::nullopt;
    }
    corner.origin_mm = volume.to_mm(place[0], place[1], place[2]);
    return same_grid(box, corner) ? std::optional(place) : std::nullopt;
}

template <class Labels>
Labels placed(const Grid& volume, Labels labels, const std::string& place) {
    if (same_grid(labels.grid, volume)) return labels;
    const auto start = place_in(volume, labels.grid);
    if (!start) require_same_grid(labels.grid, volume, place);
    Labels whole(volume);
    paste(labels, *start, whole);
    return whole;
}

}  // namespace

Mask on_grid_of(const Grid& volume, Mask mask, const std::string& place) {
    return placed(volume, std::move(mask), place);
}

LabelMap on_grid_of(const Grid& volume, LabelMap labels, const std::string& place) {
    return placed(volume, std::move(labels), place);
}

namespace {

struct Values {
    std::int16_t low = std::numeric_limits<std::int16_t>::max();
    std::int16_t high = std::numeric_limits<std::int16_t>::min();
    std::size_t soft = 0;  // voxels of soft tissue
};

Values values_of(const Volume& volume, const Job& job) {
    const std::size_t slice = volume.grid.offset(0, 0, 1);
    Values values;
    for (int z = 0; z < volume.grid.dims[2]; ++z) {
        job.throw_if_cancelled();
        for (const std::int16_t hu : std::span(&volume.at(0, 0, z), slice)) {
            values.low = std::min(values.low, hu);
            values.high = std::max(values.high, hu);
            values.soft += hu > -200 && hu < 400 && hu != 0;
        }
    }
    return values;
}

}  // namespace

void require_plausible_ct(const Volume& volume, const std::string& place, const Job& job) {
    constexpr double least_mm = 0.1, most_mm = 10.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double spacing_mm = volume.grid.spacing_mm[axis];
        if (spacing_mm >= least_mm && spacing_mm <= most_mm) continue;
        std::ostringstream problem;
        problem << "has voxels of " << spacing_mm << " mm along "
                << "xyz"[axis];
        throw InputError(problem.str(), place,
                         "Check the unit of its spacing and export it again in millimetres: the CT "
                         "of a body has voxels of 0.1 to 10 mm");
    }
    for (const int n : volume.grid.dims)
        if (n < 8)
            throw InputError("has only " + std::to_string(n) + " voxels along an axis", place,
                             "Choose a CT that covers the liver");
    const auto [low, high, soft] = values_of(volume, job);
    if (low == high)
        throw InputError("has the value " + std::to_string(low) + " in every voxel", place,
                         "Choose a CT with an image in it");
    if (static_cast<double>(soft) < 0.005 * static_cast<double>(volume.voxels.size()))
        throw InputError("shows no soft tissue (its values run from " + std::to_string(low) +
                             " to " + std::to_string(high) + " HU)",
                         place, "Choose a CT in Hounsfield units that covers the liver");
}

}  // namespace hepatica
