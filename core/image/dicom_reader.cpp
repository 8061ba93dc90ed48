// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/dicom_reader.h"

#include <gdcmImageReader.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/dicom_series.h"
#include "core/image/memory_limit.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Copy or export the series again");
}

// Bits that are stored, without what overlays may have put above them.
template <class Word>
double stored_value(Word word, int bits, bool is_signed) {
    const int unused = static_cast<int>(8 * sizeof(Word)) - bits;
    const Word shifted = static_cast<Word>(word << unused);
    if (!is_signed) return static_cast<double>(static_cast<Word>(shifted >> unused));
    using Signed = std::make_signed_t<Word>;
    return static_cast<double>(static_cast<Signed>(shifted) >> unused);
}

template <class Word>
void decode(const std::vector<char>& bytes, int bits, bool is_signed, double slope,
            double intercept, std::vector<double>& hu) {
    for (std::size_t i = 0; i < hu.size(); ++i) {
        Word word{};
        std::memcpy(&word, bytes.data() + i * sizeof(Word), sizeof(Word));
        hu[i] = slope * stored_value(word, bits, is_signed) + intercept;
    }
}

// One slice in Hounsfield units, row by row.
std::vector<double> read_pixels(const DicomSlice& slice) {
    gdcm::ImageReader reader;
    reader.SetFileName(slice.file.c_str());
    bool read = false;
    try {
        read = reader.Read();
    } catch (const std::exception&) {
        read = false;
    }
    if (!read) reject(slice.file, "cannot be decoded");
    const gdcm::Image& image = reader.GetImage();
    const gdcm::PixelFormat format = image.GetPixelFormat();
    if (format.GetSamplesPerPixel() != 1) reject(slice.file, "is a colour picture");
    const std::size_t count = static_cast<std::size_t>(slice.rows) * slice.columns;
    const std::size_t word_bytes = format.GetBitsAllocated() / 8;
    std::vector<char> bytes(image.GetBufferLength());
    if (bytes.size() < count * word_bytes || !image.GetBuffer(bytes.data()))
        reject(slice.file, "has damaged or truncated pixel data");
    std::vector<double> hu(count);
    const int bits = format.GetBitsStored();
    const bool is_signed = format.GetPixelRepresentation() != 0;
    const double slope = image.GetSlope();
    const double intercept = image.GetIntercept();
    if (!std::isfinite(slope) || !std::isfinite(intercept) || slope == 0.0)
        reject(slice.file, "has a rescale slope of " + std::to_string(slope));
    if (word_bytes == 1)
        decode<std::uint8_t>(bytes, bits, is_signed, slope, intercept, hu);
    else if (word_bytes == 2)
        decode<std::uint16_t>(bytes, bits, is_signed, slope, intercept, hu);
    else if (word_bytes == 4)
        decode<std::uint32_t>(bytes, bits, is_signed, slope, intercept, hu);
    else
        reject(slice.file, "has " + std::to_string(word_bytes * 8) + " bits a pixel");
    return hu;
}

std::int16_t clamped(double hu) {
    constexpr double low = std::numeric_limits<std::int16_t>::min();
    constexpr double high = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::lround(std::clamp(hu, low, high)));
}

void require_equal_repeats(const OrderedSeries& series, ReadRemarks& remarks) {
    for (const auto& [kept, repeat] : series.repeated) {
        const DicomSlice& original = series.slices[kept];
        if (read_pixels(original) != read_pixels(repeat))
            throw InputError("lies in the same place as " + original.file.filename().string() +
                                 " but shows something else",
                             repeat.file.string(),
                             "Put each phase of the contrast into a folder of its own");
    }
    if (!series.repeated.empty())
        remarks.push_back(std::to_string(series.repeated.size()) +
                          " slices stood there twice and were read once");
}

PlacedGrid place(const OrderedSeries& series) {
    const DicomSlice& first = series.slices.front();
    Mat3 axes;
    axes.col(0) = first.row_axis.normalized() * first.column_spacing_mm;
    axes.col(1) = first.column_axis.normalized() * first.row_spacing_mm;
    axes.col(2) = first.normal() * series.slice_spacing_mm;
    return placed_grid({first.columns, first.rows, static_cast<std::int64_t>(series.slices.size())},
                       axes, first.position_mm, first.file.parent_path().string());
}

}  // namespace

Volume read_dicom(const fs::path& folder, const fs::path& member, Job& job, ReadRemarks& remarks) {
    const OrderedSeries series = order_slices(
        choose_series(find_dicom_slices(folder, job, remarks), member, folder, remarks));
    require_equal_repeats(series, remarks);
    const PlacedGrid placed = place(series);
    const auto dims = placed.grid.dims;
    require_memory(bytes_of(dims[0], dims[1], dims[2], sizeof(std::int16_t)), folder.string());
    Volume volume(placed.grid);
    std::atomic<std::size_t> done{0};
    const std::size_t count = series.slices.size();
    parallel_blocks(count, 1, [&](std::size_t z, std::size_t) {
        const DicomSlice& slice = series.slices[z];
        job.throw_if_cancelled();
        const std::vector<double> hu = read_pixels(slice);
        std::size_t i = 0;
        for (int y = 0; y < slice.rows; ++y)
            for (int x = 0; x < slice.columns; ++x)
                volume.voxels[placed.first + x * placed.strides[0] + y * placed.strides[1] +
                              static_cast<std::ptrdiff_t>(z) * placed.strides[2]] =
                    clamped(hu[i++]);
        job.advance(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(count));
    });
    return volume;
}

}  // namespace hepatica
