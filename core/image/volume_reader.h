// SPDX-License-Identifier: GPL-3.0-or-later
// Reads images from disk into patient space (LPS, millimetres): DICOM, NIfTI, MetaImage, NRRD. A
// header is compared with the file's size and the free memory before anything is allocated, and the
// geometry of a DICOM series is checked slice by slice; anything unreliable is refused.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Decisions of the reader, in sentences for the user: series left out, slices that occurred twice,
// values clamped. Empty if nothing was unusual. File names and texts typed at the scanner are
// quoted names (quoted_name.h): for display only, not for further processing.
using ReadRemarks = std::vector<std::string>;

// Reads a CT. `file_or_folder` is a DICOM folder (with subfolders; names and extensions do not
// matter, files that are not images are skipped), any one file of a series in such a folder, a
// DICOMDIR, or a .nii, .nii.gz, .mha, .mhd, .nrrd or .nhdr file.
// `series` is a number in the list of list_series(), from 1; 0 reads the series of the named file,
// or the first of the list. The choice and its reason are in the remarks.
// A series that a tilted gantry has sheared is straightened slice by slice, each in its own plane;
// voxels that were not scanned become -1024.
// Values are in Hounsfield units after the file's slope and intercept, clamped to [-32768, 32767].
// Padding of DICOM files becomes -1024. Other values that are not finite become the mean of their
// neighbours if at least half of those are finite, else -1024.
// Begins one stage of `job` and reports progress slice by slice. Throws Cancelled, or InputError
// that names the file where it is unreadable, truncated or no CT; sizes or orientations differ
// between slices; slices are missing or gaps uneven; a spacing is not positive; an extent or a
// distance from the origin exceeds 10 m; or the header claims more than the file or the memory can
// hold.
Volume read_volume(const std::filesystem::path& file_or_folder, Job& job,
                   ReadRemarks* remarks = nullptr, int series = 0);

// One series of a DICOM folder.
struct SeriesDescription {
    std::string description;  // its number and the description from the scanner
    std::string modality;     // "CT" ...; may be blank
    std::size_t slices = 0;
    double spacing_mm = 0.0;               // between neighbouring slices; 0 if unknown
    std::string kernel;                    // in the maker's terms; may be blank
    std::string phase;                     // of the contrast, from the description; may be blank
    std::string why_not_chosen;            // compared with the first of the list; "" for the first
    std::filesystem::path middle_slice{};  // file of the middle slice
    // Reasons against it, in words: that it cannot be read and why, or that it will show little.
    std::vector<std::string> warnings{};
};

// The series in a folder, CT first and the best for the liver's vessels first: read_volume() reads
// the first by default. Begins one stage. Throws Cancelled, and InputError if the folder cannot be
// opened or holds no DICOM image.
std::vector<SeriesDescription> list_series(const std::filesystem::path& folder, Job& job);

// Reads labels (whole numbers 0 to 65535) from .nii, .nii.gz, .mha, .mhd, .nrrd, .nhdr or
// .seg.nrrd, or from a DICOM segmentation, whose segment numbers are the labels (the higher one
// where two overlap). Throws InputError as above, and where a value is not such a number;
// Cancelled.
LabelMap read_label_map(const std::filesystem::path& file, Job& job);

// A mask with the same values. Throws InputError, naming `place`, if one is above 255.
Mask narrow_labels(const LabelMap& labels, const std::string& place);

// Reads a mask from the same formats, or from a DICOM series: 1 where the value is one of `labels`,
// or is not zero if `labels` is empty; else 0. Throws InputError as above, and if no voxel is 1.
Mask read_mask(const std::filesystem::path& file, Job& job, std::span<const int> labels = {});

// Throws InputError, naming `place`, unless the mask covers the volume voxel by voxel.
void require_same_grid(const Grid& mask, const Grid& volume, const std::string& place);

// The mask on the volume's grid, if it covers a box of the volume's voxels, as segmentations are
// often saved; the rest is 0. Throws as require_same_grid() if it does not fit.
Mask on_grid_of(const Grid& volume, Mask mask, const std::string& place);
LabelMap on_grid_of(const Grid& volume, LabelMap labels, const std::string& place);

// Throws InputError, naming `place`, if nothing can be reconstructed from the volume: voxels
// smaller than 0.1 or larger than 10 mm, fewer than 8 voxels along an axis, all values equal, or
// less than 0.5 % soft tissue (-200 to 400 HU). Throws Cancelled.
void require_plausible_ct(const Volume& volume, const std::string& place, const Job& job);

}  // namespace hepatica
