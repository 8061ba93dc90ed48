// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the helper on an enhanced file and reads the slices that it writes to a temporary folder.
#include "core/image/dicom_frames.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <list>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/child_process.h"
#include "core/base/error.h"
#include "core/base/program_files.h"
#include "core/base/quoted_name.h"
#include "core/base/temporary_folder.h"
#include "core/image/memory_limit.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr const char* helper_name = "hepatica-dicom-frames";
constexpr const char* export_remedy =
    "Export it again as classic CT slices, one file a slice (a segmentation: as NIfTI or NRRD)";

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw InputError("cannot be split into its frames: " + what, file.string(), export_remedy);
}

std::uint64_t size_of(const fs::path& file) {
    std::error_code error;
    const std::uint64_t bytes = fs::file_size(file, error);
    if (error)
        throw InputError("cannot be read (" + error.message() + ")", file.string(),
                         "Check that the file is still there");
    return bytes;
}

ChildLimits limits_for(std::uint64_t file_bytes) {
    return {(std::uint64_t{1} << 30) + file_bytes, 60 + static_cast<int>(file_bytes >> 20)};
}

// The frames take about as much space as the file (those of a segmentation two bytes a pixel), plus
// a header each.
void require_room(const fs::path& folder, const DicomSlice& file, std::uint64_t file_bytes) {
    constexpr std::uint64_t header_bytes = 4096;
    const std::uint64_t label_bytes =
        file.segmentation ? bytes_of(file.columns, file.rows, file.frames, 2) : 0;
    const std::uint64_t wanted =
        std::max(file_bytes, label_bytes) + header_bytes * static_cast<std::uint64_t>(file.frames);
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (!error && space.available < wanted)
        throw InputError("needs " + readable_bytes(wanted) + " for its frames, and " +
                             readable_bytes(space.available) + " are free in " +
                             folder.parent_path().string(),
                         file.file.string(),
                         "Free some space there, or set TMPDIR to a folder "
                         "with more");
}

// The helper's message for a refused file: the problem on the first line, the remedy on the second.
std::optional<InputError> told_refusal(const std::string& errors, const fs::path& file) {
    std::istringstream lines(as_utf8(errors));
    std::string problem, remedy, more;
    if (!std::getline(lines, problem) || !std::getline(lines, remedy) || std::getline(lines, more))
        return std::nullopt;
    return InputError(problem, file.string(), remedy);
}

void require_success(const ChildOutcome& outcome, const ChildLimits& limits, const fs::path& file) {
    using End = ChildOutcome::End;
    if (outcome.end == End::exited && outcome.number == 0) return;
    if (outcome.end == End::out_of_time)
        fail(file, "that took longer than " + std::to_string(limits.seconds) + " s");
    if (outcome.end == End::killed)
        fail(file, "the helper that reads it was ended by signal " +
                       std::to_string(outcome.number) + ", which a damaged file can cause");
    if (const auto told = told_refusal(outcome.errors, file); told && outcome.number == 1)
        throw *told;
    fail(file, "the helper that reads it ended with " + std::to_string(outcome.number));
}

fs::path frame_file(const fs::path& folder, int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%06d.dcm", number);
    return folder / name.data();
}

}  // namespace

struct SplitFrames::Folders {
    std::list<TemporaryFolder> all;
};

SplitFrames::SplitFrames(fs::path program)
    : program_(std::move(program)), folders_(std::make_unique<Folders>()) {}

SplitFrames::~SplitFrames() = default;

std::vector<DicomSlice> SplitFrames::frames_of(const DicomSlice& file, const Job& job) {
    const fs::path program = program_.empty() ? helper(helper_name) : program_;
    const std::uint64_t file_bytes = size_of(file.file);
    const fs::path folder = folders_->all.emplace_back().path();
    require_room(folder, file, file_bytes);
    const ChildLimits limits = limits_for(file_bytes);
    require_success(
        run_child(program, {fs::absolute(file.file).string(), folder.string()}, limits, job),
        limits, file.file);
    std::vector<DicomSlice> frames;
    for (int number = 1; number <= file.frames; ++number) {
        job.throw_if_cancelled();
        std::optional<DicomSlice> frame = read_dicom_slice(frame_file(folder, number));
        if (!frame) fail(file.file, "frame " + std::to_string(number) + " is missing");
        frame->file = file.file.string() + " (frame " + std::to_string(number) + ")";
        frames.push_back(std::move(*frame));
    }
    return frames;
}

std::vector<DicomSlice> SplitFrames::split(std::vector<DicomSlice> slices, const Job& job) {
    std::vector<DicomSlice> all;
    for (DicomSlice& slice : slices) {
        if (!slice.enhanced) {
            all.push_back(std::move(slice));
            continue;
        }
        std::vector<DicomSlice> frames = frames_of(slice, job);
        std::move(frames.begin(), frames.end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace hepatica
