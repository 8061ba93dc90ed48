// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/dicom_slices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

void read_geometry(const DicomHeader& header, DicomSlice& slice) {
    const std::vector<double> position = header.numbers(0x0020, 0x0032);
    const std::vector<double> axes = header.numbers(0x0020, 0x0037);
    const std::vector<double> spacing = header.numbers(0x0028, 0x0030);
    if (position.size() != 3 || axes.size() != 6 || spacing.size() != 2) return;
    slice.position_mm = Vec3(position[0], position[1], position[2]);
    slice.row_axis = Vec3(axes[0], axes[1], axes[2]);
    slice.column_axis = Vec3(axes[3], axes[4], axes[5]);
    slice.row_spacing_mm = spacing[0];
    slice.column_spacing_mm = spacing[1];
    slice.has_geometry = slice.position_mm.allFinite() && slice.row_axis.allFinite() &&
                         slice.column_axis.allFinite() && std::isfinite(spacing[0]) &&
                         std::isfinite(spacing[1]);
}

void read_pixel_format(const DicomHeader& header, DicomSlice& slice) {
    slice.bits_allocated = header.unsigned_short(0x0028, 0x0100);
    slice.bits_stored = header.unsigned_short(0x0028, 0x0101, slice.bits_allocated);
    slice.is_signed = header.unsigned_short(0x0028, 0x0103) != 0;
    slice.samples_per_pixel = header.unsigned_short(0x0028, 0x0002, 1);
    slice.big_endian = header.big_endian;
    slice.compressed = header.compressed;
    slice.pixel_offset = header.pixel_offset;
    slice.pixel_bytes = header.pixel_bytes;
    slice.transfer_syntax = header.transfer_syntax;
    slice.fragments = header.fragments;
    const std::vector<double> slope = header.numbers(0x0028, 0x1053);
    const std::vector<double> intercept = header.numbers(0x0028, 0x1052);
    if (!slope.empty()) slice.slope = slope[0];
    if (!intercept.empty()) slice.intercept = intercept[0];
}

// Anonymised series may have lost their UID: study, number and description then part them.
std::string series_key(const DicomHeader& header) {
    const std::string uid = header.text(0x0020, 0x000e);
    if (!uid.empty()) return uid;
    return "no UID/" + header.text(0x0020, 0x000d) + "/" + header.text(0x0020, 0x0011) + "/" +
           header.text(0x0008, 0x103e);
}

std::string description_of(const DicomHeader& header) {
    const std::string number = header.text(0x0020, 0x0011);
    const std::string description = header.text(0x0008, 0x103e);
    std::string text = number.empty() ? "series" : "series " + number;
    if (!description.empty()) text += " \"" + description + "\"";
    return text;
}

DicomSlice slice_of(const fs::path& file, const DicomHeader& header) {
    DicomSlice slice;
    slice.file = file;
    slice.rows = header.unsigned_short(0x0028, 0x0010);
    slice.columns = header.unsigned_short(0x0028, 0x0011);
    slice.series_key = series_key(header);
    slice.description = description_of(header);
    slice.modality = header.text(0x0008, 0x0060);
    slice.localizer = header.text(0x0008, 0x0008).find("LOCALIZER") != std::string::npos;
    const std::vector<double> frames = header.numbers(0x0028, 0x0008);
    if (!frames.empty() && frames[0] > 1.0)
        slice.frames = static_cast<int>(std::min(frames[0], 1e6));
    read_geometry(header, slice);
    read_pixel_format(header, slice);
    return slice;
}

// A damaged slice would only show as a gap, so it is named; other files without an image (reports,
// a DICOMDIR) are passed over.
struct Passed {
    std::size_t without_image = 0;
    std::vector<std::string> damaged;
};

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           error);
    if (error)
        throw InputError("cannot be opened (" + error.message() + ")", folder.string(),
                         "Check that the folder exists and may be read");
    for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (error) break;
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace

Vec3 DicomSlice::normal() const {
    return row_axis.cross(column_axis).normalized();
}

std::vector<DicomSlice> find_dicom_slices(const fs::path& folder, Job& job, ReadRemarks& remarks) {
    const std::vector<fs::path> files = files_below(folder);
    if (files.empty())
        throw InputError("is empty", folder.string(), "Choose the folder that holds the CT slices");
    std::vector<DicomSlice> slices;
    Passed passed;
    for (std::size_t i = 0; i < files.size(); ++i) {
        job.advance(0.5 * static_cast<double>(i) / static_cast<double>(files.size()));
        if (!is_dicom_file(files[i])) continue;
        const std::optional<DicomHeader> header = read_dicom_header(files[i]);
        if (!header)
            passed.damaged.push_back(files[i].filename().string());
        else if (!header->has_pixels)
            ++passed.without_image;
        else
            slices.push_back(slice_of(files[i], *header));
    }
    if (passed.without_image > 0)
        remarks.push_back(std::to_string(passed.without_image) +
                          " DICOM files hold no image and were passed over");
    for (const std::string& name : passed.damaged)
        remarks.push_back(name + " is a damaged DICOM file and was passed over");
    if (slices.empty())
        throw InputError("holds " + std::to_string(files.size()) + " files, but no DICOM images",
                         folder.string(), "Choose the folder that holds the CT slices");
    return slices;
}

}  // namespace hepatica
