// SPDX-License-Identifier: GPL-3.0-or-later
// The common content of NIfTI, MetaImage and NRRD headers, and the reading of voxels by it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/base/job.h"
#include "core/image/byte_stream.h"
#include "core/image/volume.h"

namespace hepatica {

enum class ScalarType {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

int bytes_per_value(ScalarType type);

struct VoxelFile {
    std::filesystem::path header_file;  // the file that the user named
    std::filesystem::path data_file;
    std::uint64_t data_offset = 0;  // where the data begin in data_file, compressed or not
    Encoding encoding = Encoding::raw;
    std::uint64_t skip_bytes = 0;  // bytes to skip after inflating
    ScalarType type = ScalarType::int16;
    bool big_endian = false;
    double slope = 1.0;  // value = slope * stored + intercept
    double intercept = 0.0;
    std::array<std::int64_t, 3> dims{};
    Mat3 axes = Mat3::Identity();      // columns: step to the next voxel, LPS, mm
    Vec3 origin_mm = Vec3::Zero();     // centre of the first voxel, LPS
    bool orientation_assumed = false;  // the file does not say which way its axes lead
};

// A file's grid with its axes permuted and flipped to run as close to left, back and head as
// possible, and the mapping from the file's voxels to that grid. Two exports of one scan then agree
// voxel by voxel, whatever the order of their axes.
struct PlacedGrid {
    Grid grid;
    std::ptrdiff_t first = 0;                 // offset, in the grid, of the file's first voxel
    std::array<std::ptrdiff_t, 3> strides{};  // offset, in the grid, of a step along a file axis
};

// Throws InputError, naming `place`, if a size or spacing is not positive and finite, the axes are
// not at right angles (to half a degree), or the grid is longer than 10 m or begins farther away
// (see patient_space.h).
PlacedGrid placed_grid(const std::array<std::int64_t, 3>& dims, const Mat3& axes,
                       const Vec3& origin_mm, const std::string& place);

// Throws InputError if the header claims more data than the file can hold, or more than the memory
// can hold at target_bytes per voxel.
void require_affordable(const VoxelFile& file, int target_bytes);

// Passes all values to `sink` in the file's order, in runs that never cross a row: offset in the
// placed grid of the first value, step from one to the next, values after slope and intercept.
// Throws InputError where the data end early or are damaged; Cancelled.
using ValueSink =
    std::function<void(std::ptrdiff_t first, std::ptrdiff_t step, std::span<const double> values)>;
void read_values(const VoxelFile& file, const PlacedGrid& placed, const ValueSink& sink, Job& job);

// Reads the header of a .nii, .nii.gz, .mha, .mhd, .nrrd or .nhdr file, recognised by its first
// bytes and its name; throws InputError if it is none of them.
VoxelFile read_header(const std::filesystem::path& file);

// The three formats, each for a file that is known to have it.
VoxelFile read_nifti_header(const std::filesystem::path& file);
VoxelFile read_meta_header(const std::filesystem::path& file);
VoxelFile read_nrrd_header(const std::filesystem::path& file);

}  // namespace hepatica
