// SPDX-License-Identifier: GPL-3.0-or-later
// Splits multi-frame DICOM files into slices: enhanced CT (DICOM PS3.3 A.38, A.70) and
// segmentations (A.51), which hold a whole series in one file. A helper program,
// hepatica-dicom-frames (app/dicom_frames), writes their frames as classic slices. It runs as a
// child process with limits, because it uses DCMTK's parser.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"

namespace hepatica {

class SplitFrames {
  public:
    // `program` replaces the helper that comes with the program; empty: that helper.
    explicit SplitFrames(std::filesystem::path program = {});
    ~SplitFrames();

    // The slices, with every enhanced file replaced by one slice per frame, named "FILE (frame N)".
    // Their pixels can be read as long as this object lives. Throws Cancelled; InputError that
    // names the file where the helper is missing, refuses the file, crashes or exceeds its limits
    // of memory (1 GiB plus the file's size) and time (a minute plus a second per megabyte).
    std::vector<DicomSlice> split(std::vector<DicomSlice> slices, const Job& job);

  private:
    std::vector<DicomSlice> frames_of(const DicomSlice& file, const Job& job);

    std::filesystem::path program_;  // empty: the helper that came with the program
    struct Folders;
    std::unique_ptr<Folders> folders_;  // temporary folders with the frames, one per enhanced file
};

}  // namespace hepatica
