// SPDX-License-Identifier: GPL-3.0-or-later
// What the headers of NIfTI, MetaImage and NRRD come down to, and the one way to read voxels by it.
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
    std::filesystem::path header_file;  // the one the user named
    std::filesystem::path data_file;
    std::uint64_t data_offset = 0;  // where the (compressed) data begin in data_file
    Encoding encoding = Encoding::raw;
    std::uint64_t skip_bytes = 0;  // to skip after inflating
    ScalarType type = ScalarType::int16;
    bool big_endian = false;
    double slope = 1.0;  // value = slope * stored + intercept
    double intercept = 0.0;
    std::array<std::int64_t, 3> dims{};
    Mat3 axes = Mat3::Identity();   // columns: step to the next voxel along each axis, LPS, mm
    Vec3 origin_mm = Vec3::Zero();  // centre of the first voxel, LPS
};

// A file's grid turned (by whole axes only) so that its axes run as near to left, back and head as
// they can, and the way from the file's voxel to that grid's. Two exports of one scan then agree
// voxel by voxel, in whatever order they stored their axes.
struct PlacedGrid {
    Grid grid;
    std::ptrdiff_t first = 0;                 // offset in the grid of the file's first voxel
    std::array<std::ptrdiff_t, 3> strides{};  // offset in the grid of a step along a file axis
};

// Throws InputError, naming `place`, where a size or spacing is not positive and finite, the axes
// are not at right angles (to half a degree), or the grid is longer than 10 m or begins farther
// away (see patient_space.h).
PlacedGrid placed_grid(const std::array<std::int64_t, 3>& dims, const Mat3& axes,
                       const Vec3& origin_mm, const std::string& place);

// Throws InputError where the header claims more than the file can hold, or than the memory can
// where a voxel takes target_bytes.
void require_affordable(const VoxelFile& file, int target_bytes);

// Hands over all values in the file's order, in runs that never cross a row: offset in the placed
// grid of the first value, step from one to the next, values after slope and intercept.
using ValueSink =
    std::function<void(std::ptrdiff_t first, std::ptrdiff_t step, std::span<const double> values)>;
void read_values(const VoxelFile& file, const PlacedGrid& placed, const ValueSink& sink, Job& job);

// Reads the header of a .nii, .nii.gz, .mha, .mhd, .nrrd or .nhdr file, judging by its content;
// throws InputError where it is none of them.
VoxelFile read_header(const std::filesystem::path& file);

// The three formats, each for a file that is known to be one.
VoxelFile read_nifti_header(const std::filesystem::path& file);
VoxelFile read_meta_header(const std::filesystem::path& file);
VoxelFile read_nrrd_header(const std::filesystem::path& file);

}  // namespace hepatica
