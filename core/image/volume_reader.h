// SPDX-License-Identifier: GPL-3.0-or-later
// Images from disk into patient space (LPS, millimetres): a DICOM folder, NIfTI, MetaImage, NRRD.
// A header is compared with the file's size and the free memory before anything is allocated, and
// the geometry of a DICOM series is checked slice by slice: what cannot be trusted is refused.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// What the reader decided on its own, in sentences for the user: the series it left out, slices
// that stood twice, values it clamped. Empty where nothing was out of the ordinary. Names of files
// and what was typed at the scanner are quoted names (quoted_name.h): for the screen, not for what
// is passed on.
using ReadRemarks = std::vector<std::string>;

// Reads a CT. `file_or_folder` is a DICOM folder (with subfolders; names and extensions do not
// matter, files that are not images are passed over), any one file of a series in such a folder, a
// DICOMDIR, or a .nii, .nii.gz, .mha, .mhd, .nrrd or .nhdr file.
// `series` is a number in the list of list_series, from 1; 0 reads the series of the file that was
// named, or the first of the list. The choice and its reason stand in the remarks.
// A series that a tilted gantry has sheared is put upright, slice by slice in its own plane; what
// was not scanned becomes -1024.
// Values are in Hounsfield units after the file's slope and intercept, clamped to
// [-32768, 32767]; values that are not numbers and the padding of DICOM files become -1024.
// Begins one stage of `job` and reports progress slice by slice. Throws Cancelled, or InputError
// that names the file: unreadable, truncated, no CT in it, sizes or orientations that differ
// between slices, missing slices, uneven gaps, a spacing that is not positive, an
// extent or a distance from the origin beyond 10 m, a header that claims more than the file or the
// memory can hold.
Volume read_volume(const std::filesystem::path& file_or_folder, Job& job,
                   ReadRemarks* remarks = nullptr, int series = 0);

// One series of a DICOM folder.
struct SeriesDescription {
    std::string description;  // its number and what the scanner's user called it
    std::string modality;     // "CT" ...; may be blank
    std::size_t slices = 0;
    double spacing_mm = 0.0;     // between neighbouring slices; 0 where unknown
    std::string kernel;          // as its maker calls it; may be blank
    std::string phase;           // of the contrast, as far as the description tells; may be blank
    std::string why_not_chosen;  // in words, against the first of the list; "" of the first
    std::filesystem::path middle_slice{};  // the file of the one in the middle of the others
    // What speaks against it, in words: that it cannot be read and why, or that little will be
    // seen.
    std::vector<std::string> warnings{};
};

// The series that a folder holds, CT first and the best for the liver's vessels first: read_volume
// reads the first unless told otherwise. Begins one stage. Throws Cancelled, and InputError where
// the folder cannot be opened or holds no DICOM image.
std::vector<SeriesDescription> list_series(const std::filesystem::path& folder, Job& job);

// Reads labels (whole numbers 0 to 65535) from .nii, .nii.gz, .mha, .mhd, .nrrd, .nhdr or
// .seg.nrrd, or from a DICOM segmentation, whose segments' numbers are the labels (the higher where
// two overlap). Throws InputError as above, and where a value is negative or not whole.
LabelMap read_label_map(const std::filesystem::path& file, Job& job);

// A mask with the same values. Throws InputError, naming `place`, where one is above 255.
Mask narrow_labels(const LabelMap& labels, const std::string& place);

// Reads a mask from the same formats, or from a DICOM series of its own: 1 where the value is one
// of `labels`, or is not zero where `labels` is empty; else 0. Throws InputError as above, and
// where no voxel is left.
Mask read_mask(const std::filesystem::path& file, Job& job, std::span<const int> labels = {});

// Throws InputError, naming `place`, where the mask does not cover the volume voxel by voxel.
void require_same_grid(const Grid& mask, const Grid& volume, const std::string& place);

// The same on the volume's grid where it covers a box of the volume's voxels, as segmentations are
// often saved: the rest is 0. Throws as require_same_grid() does where it does not fit.
Mask on_grid_of(const Grid& volume, Mask mask, const std::string& place);
LabelMap on_grid_of(const Grid& volume, LabelMap labels, const std::string& place);

// Throws InputError, naming `place`, where nothing can be reconstructed from the volume: voxels
// smaller than 0.1 or larger than 10 mm, fewer than 8 voxels along an axis, all values equal, or no
// soft tissue (-200 to 400 HU) in sight.
void require_plausible_ct(const Volume& volume, const std::string& place, const Job& job);

}  // namespace hepatica
