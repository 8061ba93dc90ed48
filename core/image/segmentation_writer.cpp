// SPDX-License-Identifier: GPL-3.0-or-later
// Samples the label maps at the pixels of the CT's slices and passes the frames to the helper.
#include "core/image/segmentation_writer.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/child_process.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/program_files.h"
#include "core/base/quoted_name.h"
#include "core/base/temporary_folder.h"
#include "core/image/dicom_reader.h"
#include "core/image/dicom_segmentation.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr const char* segmentation_helper = "hepatica-dicom-segmentation";
constexpr int exit_unwritable = 3;  // of the helper, as in app/dicom_segmentation/order.h
constexpr ChildLimits helper_limits{std::uint64_t{2} << 30, 120};

using Pixels = std::vector<std::uint8_t>;

// The pixels of each segment in one slice; empty if the segment has none.
std::vector<Pixels> segments_in(const DicomSlice& slice, std::size_t segments,
                                std::span<const SegmentLayer> layers) {
    std::vector<Pixels> found(segments);
    const std::size_t count = static_cast<std::size_t>(slice.rows) * slice.columns;
    const Mat3 steps = slice.steps_mm(1.0);
    for (const SegmentLayer& layer : layers) {
        std::array<std::optional<std::size_t>, 256> segment_of{};
        for (const auto& [label, segment] : layer.segment_of) segment_of[label] = segment;
        std::size_t at = 0;
        for (int y = 0; y < slice.rows; ++y)
            for (int x = 0; x < slice.columns; ++x, ++at) {
                const Vec3 centre = slice.position_mm + x * steps.col(0) + y * steps.col(1);
                const auto segment = segment_of[value_at(*layer.voxels, centre)];
                if (!segment) continue;
                Pixels& pixels = found[*segment];
                if (pixels.empty()) pixels.resize(count, 0);
                pixels[at] = 1;
            }
    }
    return found;
}

struct FoundFrame {
    std::size_t segment = 0;
    std::uint32_t slice = 0;
    Pixels pixels;
};

// Segment by segment, the order of frames that the standard requires.
std::vector<FoundFrame> frames_of(const std::vector<DicomSlice>& slices, std::size_t segments,
                                  std::span<const SegmentLayer> layers, Job& job) {
    std::vector<std::vector<Pixels>> by_slice(slices.size());
    parallel_blocks(slices.size(), 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        by_slice[z] = segments_in(slices[z], segments, layers);
    });
    std::vector<FoundFrame> frames;
    for (std::size_t segment = 0; segment < segments; ++segment)
        for (std::size_t z = 0; z < slices.size(); ++z)
            if (!by_slice[z][segment].empty())
                frames.push_back(
                    {segment, static_cast<std::uint32_t>(z), std::move(by_slice[z][segment])});
    return frames;
}

std::string value(const std::string& text) {
    return text + '\0';
}

void require_flushed(std::ofstream& out, const fs::path& file) {
    if (!out.flush())
        throw InputError("cannot be written", file.string(),
                         "Free some space there, or set TMPDIR to a folder with more");
}

void write_bytes(const fs::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    require_flushed(out, file);
}

// Writes the input of the helper (app/dicom_segmentation/order.h): the segments that have a frame,
// numbered from 1, and their frames.
void write_order(const fs::path& folder, std::span<const SegmentMeaning> segments,
                 const std::vector<DicomSlice>& slices, const std::vector<FoundFrame>& frames) {
    std::string files, meanings;
    std::ofstream out(folder / "frames", std::ios::binary);
    const auto put = [&out](const void* bytes, std::size_t count) {
        out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    };
    for (const DicomSlice& slice : slices) files += value(fs::absolute(slice.file).string());
    std::optional<std::size_t> last;
    std::uint16_t number = 0;
    for (const FoundFrame& frame : frames) {
        if (frame.segment != last) {
            const SegmentMeaning& segment = segments[frame.segment];
            const auto [r, g, b] = segment.srgb;
            meanings +=
                value(segment.label) + value(segment.category.code) +
                value(segment.category.meaning) + value(segment.type.code) +
                value(segment.type.meaning) +
                value(std::to_string(r) + " " + std::to_string(g) + " " + std::to_string(b));
            last = frame.segment;
            ++number;
        }
        put(&number, sizeof number);
        put(&frame.slice, sizeof frame.slice);
        put(frame.pixels.data(), frame.pixels.size());
    }
    require_flushed(out, folder / "frames");
    write_bytes(folder / "slices", files);
    write_bytes(folder / "segments", meanings);
}

void run_helper(const fs::path& order, const std::string& version, const fs::path& file,
                const fs::path& ct, const Job& job) {
    const ChildOutcome outcome = run_child(
        helper(segmentation_helper), {order.string(), version, file.string()}, helper_limits, job);
    using End = ChildOutcome::End;
    if (outcome.end == End::exited && outcome.number == 0) return;
    if (outcome.end == End::exited && outcome.number == exit_unwritable)
        throw InputError("cannot be written: the disk takes no more", file.string(),
                         "Free some space there, or choose another folder");
    std::istringstream lines(as_utf8(outcome.errors));
    std::string problem, remedy;
    if (outcome.end == End::exited && outcome.number == 1 && std::getline(lines, problem) &&
        std::getline(lines, remedy))
        throw InputError("its segmentation " + problem, ct.string(), remedy);
    throw InputError("its segmentation cannot be written: the helper that does it " +
                         (outcome.end == End::out_of_time
                              ? "took longer than " + std::to_string(helper_limits.seconds) + " s"
                              : std::string(outcome.end == End::killed ? "was ended by signal "
                                                                       : "ended with ") +
                                    std::to_string(outcome.number)),
                     ct.string(), "Export the CT again, or install the program again");
}

std::vector<DicomSlice> classic_slices(const fs::path& ct, int series, Job& job) {
    std::vector<DicomSlice> slices = find_series(ct, series, job).slices;
    if (std::ranges::any_of(slices, &DicomSlice::enhanced))
        throw InputError("is an enhanced CT, all of its slices in one file", ct.string(),
                         "Segmentations are written for classic slices, one file each: export it "
                         "as these");
    return slices;
}

}  // namespace

void require_segmentation_place(const fs::path& file) {
    std::error_code ignored;
    if (fs::exists(file, ignored) && !is_dicom_segmentation(file))
        throw InputError("is there and is no segmentation", file.string(),
                         "Choose another name, or take the file away");
}

void write_dicom_segmentation(const fs::path& file, std::span<const SegmentMeaning> segments,
                              std::span<const SegmentLayer> layers, const fs::path& ct, int series,
                              const std::string& program_version, Job& job) {
    require_segmentation_place(file);
    job.begin_stage("Writing the segmentation");
    const std::vector<DicomSlice> slices = classic_slices(ct, series, job);
    const std::vector<FoundFrame> frames = frames_of(slices, segments.size(), layers, job);
    if (frames.empty())
        throw InputError("nothing of the segmentation lies in this CT", ct.string(),
                         "Choose the CT that it was made of");
    const TemporaryFolder order;
    write_order(order.path(), segments, slices, frames);
    write_file_atomically(file, [&](const fs::path& temporary) {
        run_helper(order.path(), program_version, temporary, ct, job);
    });
}

}  // namespace hepatica
