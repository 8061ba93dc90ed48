// SPDX-License-Identifier: GPL-3.0-or-later
// Grid placement, size checks and decoding that all three formats share.
#include "core/image/voxel_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/patient_space.h"
#include "core/base/quoted_name.h"
#include "core/image/header_text.h"
#include "core/image/memory_limit.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr double greatest_axis_cosine = 0.0087;  // half a degree off a right angle
constexpr std::uint64_t deflate_limit = 1032;    // largest expansion of deflate, per byte

[[noreturn]] void reject_geometry(const std::string& what, const std::string& place) {
    throw InputError(what, place, "Export the image again, with its spacing and orientation");
}

// Gram-Schmidt: an orthonormal basis close to three almost orthogonal unit vectors; mirrored ones
// stay mirrored.
Mat3 orthonormal(const Mat3& m) {
    Mat3 q = m;
    q.col(1) -= q.col(0) * q.col(0).dot(q.col(1));
    q.col(1).normalize();
    q.col(2) -= q.col(0) * q.col(0).dot(q.col(2)) + q.col(1) * q.col(1).dot(q.col(2));
    q.col(2).normalize();
    return q;
}

// For each file axis, the patient axis it is assigned to, by the largest components first.
std::array<int, 3> patient_axes(const Mat3& direction) {
    std::array<int, 3> axes{-1, -1, -1};
    std::array<bool, 3> taken{};
    for (int round = 0; round < 3; ++round) {
        double best = -1.0;
        int file_axis = 0;
        int patient_axis = 0;
        for (int f = 0; f < 3; ++f)
            for (int p = 0; p < 3; ++p)
                if (axes[f] < 0 && !taken[p] && std::abs(direction(p, f)) > best + 1e-9) {
                    best = std::abs(direction(p, f));
                    file_axis = f;
                    patient_axis = p;
                }
        axes[file_axis] = patient_axis;
        taken[patient_axis] = true;
    }
    return axes;
}

template <class Stored>
void decode(const unsigned char* bytes, std::span<double> values, bool swap) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::array<unsigned char, sizeof(Stored)> raw;
        std::memcpy(raw.data(), bytes + i * sizeof(Stored), sizeof(Stored));
        if (swap) std::reverse(raw.begin(), raw.end());
        values[i] = static_cast<double>(std::bit_cast<Stored>(raw));
    }
}

void decode(ScalarType type, const unsigned char* bytes, std::span<double> values, bool swap) {
    switch (type) {
        case ScalarType::int8:
            return decode<std::int8_t>(bytes, values, swap);
        case ScalarType::uint8:
            return decode<std::uint8_t>(bytes, values, swap);
        case ScalarType::int16:
            return decode<std::int16_t>(bytes, values, swap);
        case ScalarType::uint16:
            return decode<std::uint16_t>(bytes, values, swap);
        case ScalarType::int32:
            return decode<std::int32_t>(bytes, values, swap);
        case ScalarType::uint32:
            return decode<std::uint32_t>(bytes, values, swap);
        case ScalarType::int64:
            return decode<std::int64_t>(bytes, values, swap);
        case ScalarType::uint64:
            return decode<std::uint64_t>(bytes, values, swap);
        case ScalarType::float32:
            return decode<float>(bytes, values, swap);
        case ScalarType::float64:
            return decode<double>(bytes, values, swap);
    }
}

bool starts_with_gzip_mark(const std::array<unsigned char, 8>& head) {
    return head[0] == 0x1f && head[1] == 0x8b;
}

}  // namespace

int bytes_per_value(ScalarType type) {
    switch (type) {
        case ScalarType::int8:
        case ScalarType::uint8:
            return 1;
        case ScalarType::int16:
        case ScalarType::uint16:
            return 2;
        case ScalarType::int32:
        case ScalarType::uint32:
        case ScalarType::float32:
            return 4;
        default:
            return 8;
    }
}

PlacedGrid placed_grid(const std::array<std::int64_t, 3>& dims, const Mat3& axes,
                       const Vec3& origin_mm, const std::string& place) {
    Mat3 direction;
    Vec3 spacing;
    for (int a = 0; a < 3; ++a) {
        if (dims[a] < 1 || dims[a] > std::numeric_limits<int>::max())
            reject_geometry("has " + std::to_string(dims[a]) + " voxels along an axis", place);
        spacing[a] = axes.col(a).norm();
        if (!(spacing[a] > 1e-6) || !(spacing[a] < farthest_mm))
            reject_geometry("has a voxel spacing of " + number_text(spacing[a]) + " mm", place);
        const double extent_mm = spacing[a] * static_cast<double>(dims[a]);
        if (!(extent_mm <= farthest_mm))
            reject_geometry("is " + number_text(extent_mm / 1000.0) + " m long (" +
                                std::to_string(dims[a]) + " voxels of " + number_text(spacing[a]) +
                                " mm)",
                            place);
        direction.col(a) = axes.col(a) / spacing[a];
    }
    require_in_patient_space(origin_mm, "its first voxel", place);
    for (int a = 0; a < 3; ++a)
        if (std::abs(direction.col(a).dot(direction.col((a + 1) % 3))) > greatest_axis_cosine)
            reject_geometry("has axes that are not at right angles (a sheared grid)", place);
    direction = orthonormal(direction);

    PlacedGrid placed;
    const std::array<int, 3> along = patient_axes(direction);
    std::array<bool, 3> flipped{};
    placed.grid.origin_mm = origin_mm + Vec3::Zero();
    for (int a = 0; a < 3; ++a) {
        flipped[a] = direction(along[a], a) < 0.0;
        const double sign = flipped[a] ? -1.0 : 1.0;
        placed.grid.dims[along[a]] = static_cast<int>(dims[a]);
        placed.grid.spacing_mm[along[a]] = spacing[a];
        // Adding zero turns -0 into 0.
        placed.grid.direction.col(along[a]) = sign * direction.col(a) + Vec3::Zero();
        if (flipped[a])
            placed.grid.origin_mm +=
                direction.col(a) * spacing[a] * static_cast<double>(dims[a] - 1);
    }
    const std::array<std::ptrdiff_t, 3> grid_strides{
        1, placed.grid.dims[0],
        static_cast<std::ptrdiff_t>(placed.grid.dims[0]) * placed.grid.dims[1]};
    for (int a = 0; a < 3; ++a) {
        placed.strides[a] = grid_strides[along[a]] * (flipped[a] ? -1 : 1);
        if (flipped[a]) placed.first += grid_strides[along[a]] * (dims[a] - 1);
    }
    return placed;
}

void require_affordable(const VoxelFile& file, int target_bytes) {
    const std::string place = file.header_file.string();
    for (const std::int64_t n : file.dims)
        if (n < 1) reject_geometry("has " + std::to_string(n) + " voxels along an axis", place);
    std::error_code error;
    const std::uint64_t stored = fs::file_size(file.data_file, error);
    if (error)
        throw InputError(
            "its data file " + quoted_name(file.data_file.filename().string()) + " is missing",
            place, "Keep both files in one folder");
    const std::uint64_t data = stored > file.data_offset ? stored - file.data_offset : 0;
    const std::uint64_t claimed =
        bytes_of(file.dims[0], file.dims[1], file.dims[2], bytes_per_value(file.type));
    const std::uint64_t most =
        file.encoding == Encoding::raw ? data : data * deflate_limit + file.skip_bytes;
    if (claimed > most) {
        const std::string sizes = std::to_string(file.dims[0]) + " x " +
                                  std::to_string(file.dims[1]) + " x " +
                                  std::to_string(file.dims[2]);
        throw InputError("its header claims " + sizes + " voxels (" + readable_bytes(claimed) +
                             "), which a file of " + readable_bytes(stored) + " cannot hold",
                         place, "Copy or export the file again");
    }
    require_memory(bytes_of(file.dims[0], file.dims[1], file.dims[2], target_bytes), place);
}

void read_values(const VoxelFile& file, const PlacedGrid& placed, const ValueSink& sink, Job& job) {
    ByteStream stream(file.data_file, file.data_offset, file.encoding);
    stream.skip(file.skip_bytes);
    const int size = bytes_per_value(file.type);
    const auto row = static_cast<std::size_t>(file.dims[0]);
    // A damaged header may claim any length of a row, so rows are read in parts.
    const std::size_t part = std::min<std::size_t>(row, 1 << 16);
    std::vector<unsigned char> bytes(part * size);
    std::vector<double> values(part);
    const bool swap = file.big_endian != (std::endian::native == std::endian::big);
    std::size_t since_report = 0;
    for (std::int64_t z = 0; z < file.dims[2]; ++z)
        for (std::int64_t y = 0; y < file.dims[1]; ++y) {
            const std::ptrdiff_t start =
                placed.first + y * placed.strides[1] + z * placed.strides[2];
            for (std::size_t x = 0; x < row; x += part) {
                const std::size_t count = std::min(part, row - x);
                stream.read(bytes.data(), count * size);
                const std::span<double> run(values.data(), count);
                decode(file.type, bytes.data(), run, swap);
                for (double& value : run) value = value * file.slope + file.intercept;
                sink(start + static_cast<std::ptrdiff_t>(x) * placed.strides[0], placed.strides[0],
                     run);
                since_report += count;
                if (since_report < (1u << 18)) continue;
                since_report = 0;
                job.advance((static_cast<double>(z) +
                             static_cast<double>(y) / static_cast<double>(file.dims[1])) /
                            static_cast<double>(file.dims[2]));
            }
        }
    // Reading to the end of the compressed data makes zlib check their checksum.
    if (file.encoding == Encoding::deflated) stream.read_some(bytes.data(), 1);
}

VoxelFile read_header(const fs::path& file) {
    std::array<unsigned char, 8> head{};
    {
        ByteStream raw(file, 0, Encoding::raw);
        raw.read_some(head.data(), head.size());
    }
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    const std::string name = lower_case(file.filename().string());
    if (text.starts_with("NRRD")) return read_nrrd_header(file);
    if (name.ends_with(".mha") || name.ends_with(".mhd")) return read_meta_header(file);
    if (name.ends_with(".nii") || name.ends_with(".nii.gz") || name.ends_with(".hdr") ||
        name.ends_with(".img") || starts_with_gzip_mark(head))
        return read_nifti_header(file);
    throw InputError("is not an image that this program knows", file.string(),
                     "Choose a DICOM folder or a .nii, .nii.gz, .mha, .mhd, .nrrd file");
}

}  // namespace hepatica
