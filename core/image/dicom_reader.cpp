// SPDX-License-Identifier: GPL-3.0-or-later
// Stored values to Hounsfield units, and slices to a volume. Compressed pixels are handed to GDCM's
// decoders without its file parser.
#include "core/image/dicom_reader.h"

#include <gdcmBitmap.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/quoted_name.h"
#include "core/image/codestream.h"
#include "core/image/dicom_frames.h"
#include "core/image/dicom_header.h"
#include "core/image/dicom_rle.h"
#include "core/image/header_text.h"
#include "core/image/hounsfield.h"
#include "core/image/memory_limit.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Copy or export the series again");
}

std::size_t pixels_in(const DicomSlice& slice) {
    return static_cast<std::size_t>(slice.rows) * slice.columns;
}

// The stored bits, from the high bit down, without overlay bits around them.
template <class Word>
double stored_value(Word word, const DicomSlice& slice) {
    const int word_bits = static_cast<int>(8 * sizeof(Word));
    const int unused = word_bits - slice.bits_stored;
    const Word shifted = static_cast<Word>(word << (word_bits - 1 - slice.high_bit));
    if (!slice.is_signed) return static_cast<double>(static_cast<Word>(shifted >> unused));
    using Signed = std::make_signed_t<Word>;
    return static_cast<double>(static_cast<Signed>(shifted) >> unused);
}

constexpr double padded = std::numeric_limits<double>::quiet_NaN();  // marks padding

template <class Word>
std::vector<double> to_hu(const std::vector<char>& bytes, const DicomSlice& slice, bool swap) {
    std::vector<double> hu(pixels_in(slice));
    const auto [low, high] = slice.padding.value_or(std::pair(1.0, 0.0));
    for (std::size_t i = 0; i < hu.size(); ++i) {
        std::array<char, sizeof(Word)> raw;
        std::memcpy(raw.data(), bytes.data() + i * sizeof(Word), sizeof(Word));
        if (swap) std::reverse(raw.begin(), raw.end());
        const double stored = stored_value(std::bit_cast<Word>(raw), slice);
        const bool is_padding = stored >= low && stored <= high;
        hu[i] = is_padding ? padded : slice.slope * stored + slice.intercept;
    }
    return hu;
}

std::vector<char> read_plain(const DicomSlice& slice, std::size_t bytes) {
    if (slice.pixel_bytes < bytes) reject(slice.file, "has fewer pixels than its header claims");
    std::vector<char> buffer(bytes);
    const bool deflated = slice.deflated_at > 0;
    ByteStream stream(slice.pixel_file, deflated ? slice.deflated_at : slice.pixel_offset,
                      deflated ? Encoding::bare_deflated : Encoding::raw);
    if (deflated) stream.skip(slice.pixel_offset);
    stream.read(buffer.data(), bytes);
    return buffer;
}

using Fragment = std::vector<unsigned char>;

// The fragments of the compressed pixels.
std::vector<Fragment> read_fragments(const DicomSlice& slice) {
    std::vector<Fragment> fragments;
    for (const FileRange& range : slice.fragments) {
        fragments.emplace_back(range.bytes);
        ByteStream(slice.pixel_file, range.offset, Encoding::raw)
            .read(fragments.back().data(), range.bytes);
    }
    return fragments;
}

// Refuses a picture whose own size differs from the header's: a decoder might write beyond the
// buffer.
void require_stated_size(const DicomSlice& slice, const Fragment& first_fragment) {
    const std::optional<CodestreamSize> size = codestream_size(first_fragment);
    if (!size || size->columns != slice.columns || size->rows != slice.rows ||
        size->components != 1 || size->bits > slice.bits_allocated)
        reject(slice.file, "has compressed pixels of another size than its header");
}

// The pixels as input for GDCM's decoders. This avoids its parser of whole files, which terminates
// the program on some damaged ones.
gdcm::Bitmap bitmap_of(const DicomSlice& slice, const std::vector<Fragment>& fragments,
                       gdcm::TransferSyntax::TSType syntax) {
    const gdcm::SmartPointer<gdcm::SequenceOfFragments> sequence = new gdcm::SequenceOfFragments();
    for (const Fragment& bytes : fragments) {
        gdcm::Fragment fragment;
        fragment.SetByteValue(reinterpret_cast<const char*>(bytes.data()),
                              static_cast<std::uint32_t>(bytes.size()));
        sequence->AddFragment(fragment);
    }
    gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
    element.SetVR(gdcm::VR::OB);
    element.SetValue(*sequence);

    const auto bits = [](int n) { return static_cast<unsigned short>(n); };
    gdcm::Bitmap image;
    image.SetNumberOfDimensions(2);
    image.SetDimension(0, static_cast<unsigned>(slice.columns));
    image.SetDimension(1, static_cast<unsigned>(slice.rows));
    image.SetPixelFormat(gdcm::PixelFormat(1, bits(slice.bits_allocated), bits(slice.bits_stored),
                                           bits(slice.bits_stored - 1), slice.is_signed ? 1 : 0));
    image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    image.SetTransferSyntax(syntax);
    image.SetDataElement(element);
    return image;
}

std::vector<char> read_compressed(const DicomSlice& slice, std::size_t bytes) {
    const auto syntax = gdcm::TransferSyntax::GetTSType(slice.transfer_syntax.c_str());
    const std::vector<Fragment> fragments = read_fragments(slice);
    if (fragments.empty() || syntax == gdcm::TransferSyntax::TS_END)
        reject(slice.file, "has pixels in the unknown encoding " + slice.transfer_syntax);
    if (syntax == gdcm::TransferSyntax::RLELossless) {
        auto words = decode_rle(fragments.front(), pixels_in(slice), slice.bits_allocated / 8);
        if (!words) reject(slice.file, "has damaged run-length encoded pixels");
        return *std::move(words);
    }
    require_stated_size(slice, fragments.front());
    const gdcm::Bitmap image = bitmap_of(slice, fragments, syntax);
    std::vector<char> buffer(bytes);
    bool decoded = false;
    try {
        decoded = image.GetBufferLength() == bytes && image.GetBuffer(buffer.data());
    } catch (const std::exception&) {
        decoded = false;
    }
    if (!decoded) reject(slice.file, "has compressed pixels that cannot be decoded");
    return buffer;
}

void require_known_format(const DicomSlice& slice) {
    if (slice.samples_per_pixel != 1) reject(slice.file, "is a colour picture");
    const int bits = slice.bits_allocated;
    if ((bits != 8 && bits != 16 && bits != 32) || slice.bits_stored < 1 ||
        slice.bits_stored > bits)
        reject(slice.file, "has " + std::to_string(slice.bits_stored) + " of " +
                               std::to_string(bits) + " bits a pixel");
    if (slice.high_bit < slice.bits_stored - 1 || slice.high_bit >= bits)
        reject(slice.file, "has " + std::to_string(slice.bits_stored) +
                               " bits below the high bit " + std::to_string(slice.high_bit) +
                               " (0028,0102), which is impossible in " + std::to_string(bits));
    if (slice.compressed && slice.high_bit != slice.bits_stored - 1)
        reject(slice.file, "has compressed pixels that do not begin at the lowest bit (high bit " +
                               std::to_string(slice.high_bit) + ", 0028,0102)");
    if (!std::isfinite(slice.slope) || !std::isfinite(slice.intercept) || slice.slope == 0.0)
        reject(slice.file, "has a rescale slope of " + number_text(slice.slope));
}

}  // namespace

std::vector<double> read_pixels(const DicomSlice& slice) {
    require_known_format(slice);
    const std::size_t bytes = pixels_in(slice) * (slice.bits_allocated / 8);
    const std::vector<char> buffer =
        slice.compressed ? read_compressed(slice, bytes) : read_plain(slice, bytes);
    const bool swap = slice.big_endian && !slice.compressed;
    if (slice.bits_allocated == 8) return to_hu<std::uint8_t>(buffer, slice, swap);
    if (slice.bits_allocated == 16) return to_hu<std::uint16_t>(buffer, slice, swap);
    return to_hu<std::uint32_t>(buffer, slice, swap);
}

namespace {

bool is_same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

void require_equal_repeats(const OrderedSeries& series, ReadRemarks& remarks, const Job& job) {
    for (const auto& [kept, repeat] : series.repeated) {
        job.throw_if_cancelled();
        const DicomSlice& original = series.slices[kept];
        if (!std::ranges::equal(read_pixels(original), read_pixels(repeat), is_same))
            throw InputError(
                "lies in the same place as " + quoted_name(original.file.filename().string()) +
                    " but shows something else",
                repeat.file.string(), "Put each phase of the contrast into a folder of its own");
    }
    if (!series.repeated.empty())
        remarks.push_back(std::to_string(series.repeated.size()) +
                          " slices stood there twice and were read once");
}

// Decoding needs a few copies of one slice; the size in its header may be false.
void require_room(const DicomSlice& slice) {
    const std::uint64_t pixels = bytes_of(slice.rows, slice.columns, 1, slice.bits_allocated / 8);
    if (!slice.compressed && pixels > slice.pixel_bytes)
        reject(slice.file, "has fewer pixels than its header claims");
    require_memory(8 * pixels, slice.file.string());
}

// Remarks on headers that can be read in two ways.
void remark_on_values(const std::vector<DicomSlice>& slices, ReadRemarks& remarks) {
    if (std::ranges::any_of(slices, &DicomSlice::inverted_display))
        remarks.push_back(
            "The series is stored for display with low values bright (MONOCHROME1): its values "
            "were read as Hounsfield units all the same, as the standard has it");
    // Unsigned values without rescale may have air at 0 instead of -1000.
    const auto unscaled = std::ranges::count_if(
        slices, [](const DicomSlice& s) { return !s.has_rescale && !s.is_signed; });
    if (unscaled > 0)
        remarks.push_back(std::to_string(unscaled) +
                          " slices state no rescale slope and intercept: their stored values were "
                          "taken as Hounsfield units");
}

std::string degrees(double angle) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g degrees", angle);
    return text.data();
}

// The standard (PS3.3 C.8.2.1) requires the tilt to be computed from positions and orientations,
// not taken from its tag, which some scanners keep in series that they have straightened.
void remark_on_tilt(const OrderedSeries& series, ReadRemarks& remarks) {
    constexpr double noticeable_degrees = 1.0;
    const double stated = std::abs(series.slices.front().stated_tilt_degrees);
    if (series.tilt_degrees > 0.0)
        remarks.push_back("Its slices are stacked aslant by " + degrees(series.tilt_degrees) +
                          " (a tilted gantry): each was moved within its plane onto an upright "
                          "grid");
    if (stated > 0.0 && std::abs(stated - series.tilt_degrees) > noticeable_degrees)
        remarks.push_back("The series states a gantry tilt of " + degrees(stated) +
                          " (0018,1120), but its slices are stacked " +
                          (series.tilt_degrees > 0.0 ? "otherwise" : "straight") +
                          ": it was read by their positions, as the standard has it");
}

PlacedGrid place(const OrderedSeries& series, const UprightStack& stack) {
    const DicomSlice& first = series.slices.front();
    return placed_grid(
        {stack.columns(), stack.rows(), static_cast<std::int64_t>(series.slices.size())},
        first.steps_mm(series.slice_spacing_mm), stack.origin_mm(),
        first.file.parent_path().string());
}

// Writes the values of slice z into the volume; returns how many had to be clamped.
std::size_t fill_slice(Volume& volume, const PlacedGrid& placed, const UprightStack& stack,
                       std::size_t z, const std::vector<double>& hu, std::int16_t padding_value) {
    std::size_t i = 0, clamped = 0;
    for (int y = 0; y < stack.rows(); ++y)
        for (int x = 0; x < stack.columns(); ++x, ++i) {
            const bool is_padding = std::isnan(hu[i]);
            if (!is_padding && !fits_hounsfield(hu[i])) ++clamped;
            volume.voxels[placed.first + x * placed.strides[0] + y * placed.strides[1] +
                          static_cast<std::ptrdiff_t>(z) * placed.strides[2]] =
                is_padding ? padding_value : nearest_hounsfield(hu[i]);
        }
    return clamped;
}

// False where there is nothing. Throws InputError where that cannot be looked up.
bool is_folder(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::status_known(status))
        throw InputError("cannot be opened (" + error.message() + ")", path.string(),
                         "Check that it exists and may be read");
    return fs::is_directory(status);
}

// Keeps GDCM from writing messages about damaged files to the terminal.
void silence_gdcm() {
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
}

}  // namespace

std::vector<double> slice_hu(const DicomSlice& slice) {
    if (slice.frames > 1) reject(slice.file, "holds several frames in one file");
    if (!slice.problem.empty()) reject(slice.file, slice.problem);
    if (slice.rows < 1 || slice.columns < 1) reject(slice.file, "has no pixels");
    silence_gdcm();
    require_room(slice);
    return read_pixels(slice);
}

DicomPlace dicom_place(const fs::path& path) {
    if (is_folder(path)) return {path, {}};
    std::error_code ignored;  // of a path of no letters
    const fs::path file = fs::absolute(path, ignored);
    return {file.parent_path(), is_dicom_file(file) ? file : fs::path{}};
}

OrderedSeries find_series(const fs::path& path, int series, Job& job) {
    const DicomPlace place = dicom_place(path);
    if (!is_folder(path) && place.member.empty() &&
        lower_case(path.filename().string()) != "dicomdir")
        throw InputError("is no DICOM image", path.string(),
                         "Give the DICOM folder of the CT, or a file in it");
    silence_gdcm();
    ReadRemarks unheard;
    std::vector<DicomSlice> slices = choose_series(find_dicom_slices(place.folder, job, unheard),
                                                   {place.member, series}, place.folder, unheard);
    if (std::ranges::any_of(slices, &DicomSlice::enhanced))
        return {std::move(slices), {}, 0.0, 0.0};
    return order_slices(std::move(slices));
}

Volume read_dicom(const fs::path& folder, const DicomWish& wish, Job& job, ReadRemarks& remarks) {
    silence_gdcm();
    SplitFrames split;  // keeps the frames of enhanced files until they are read
    const OrderedSeries series = order_slices(split.split(
        choose_series(find_dicom_slices(folder, job, remarks), wish.series, folder, remarks), job));
    remark_on_values(series.slices, remarks);
    remark_on_tilt(series, remarks);
    require_room(series.slices.front());
    require_equal_repeats(series, remarks, job);
    const UprightStack stack(series, wish.between);
    const PlacedGrid placed = place(series, stack);
    const Index3& dims = placed.grid.dims;
    require_memory(bytes_of(dims[0], dims[1], dims[2], sizeof(std::int16_t)), folder.string());
    Volume volume(placed.grid);
    std::atomic<std::size_t> done{0}, padding{0}, clamped{0};
    const std::size_t count = series.slices.size();
    parallel_blocks(count, 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        std::vector<double> hu = read_pixels(series.slices[z]);
        padding += std::ranges::count_if(hu, [](double value) { return std::isnan(value); });
        clamped +=
            fill_slice(volume, placed, stack, z, stack.moved(z, std::move(hu)), wish.padding_value);
        job.advance(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(count));
    });
    if (padding > 0)
        remarks.push_back(std::to_string(padding) + " of " + std::to_string(volume.voxels.size()) +
                          " voxels are padding around the scan (0028,0120) and became " +
                          std::to_string(wish.padding_value));
    if (clamped > 0) remarks.push_back(remark_on_clamped(clamped));
    return volume;
}

}  // namespace hepatica
