// SPDX-License-Identifier: GPL-3.0-or-later
// Enhanced multi-frame CT (DICOM PS3.3 A.38, A.70) and segmentations (A.51), a series in one file.
// A helper, hepatica-dicom-frames (app/dicom_frames), writes their frames as classic slices: a
// child process under limits, because it reads them by DCMTK's parser.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"

namespace hepatica {

class SplitFrames {
  public:
    // `program` stands in for the helper that came with the program.
    explicit SplitFrames(std::filesystem::path program = {});
    ~SplitFrames();

    // The slices with one of each frame in the place of every enhanced file: called "FILE (frame
    // N)", and to be read for as long as this object lives. Throws Cancelled; InputError that names
    // the file, where the helper is missing, refuses the file, crashes, or takes more than its
    // limits of memory (1 GiB and the file's size) and time (a minute, and a second for each
    // megabyte).
    std::vector<DicomSlice> split(std::vector<DicomSlice> slices, const Job& job);

  private:
    std::vector<DicomSlice> frames_of(const DicomSlice& file, const Job& job);

    std::filesystem::path program_;  // empty: the helper that came with the program
    struct Folders;
    std::unique_ptr<Folders> folders_;  // with the frames, one of each enhanced file
};

}  // namespace hepatica
