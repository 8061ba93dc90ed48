// SPDX-License-Identifier: GPL-3.0-or-later
// Turns parsed headers into records of slices, and searches a folder for them.
#include "core/image/dicom_slices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/quoted_name.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// `position`, `axes`, `spacing`: values of (0020,0032), (0020,0037) and (0028,0030).
void set_geometry(const std::vector<double>& position, const std::vector<double>& axes,
                  const std::vector<double>& spacing, DicomSlice& slice) {
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

void read_geometry(const DicomHeader& header, DicomSlice& slice) {
    set_geometry(header.numbers(0x0020, 0x0032), header.numbers(0x0020, 0x0037),
                 header.numbers(0x0028, 0x0030), slice);
}

// An enhanced file describes its frames in functional groups, with the values that a classic slice
// has at the top level. Here the first value is taken for all frames; the exact values are read
// after splitting.
void read_functional_groups(const DicomHeader& header, DicomSlice& slice) {
    if (slice.kernel.empty()) slice.kernel = header.group_text(0x0018, 0x1210);
    slice.contrast_agent = slice.contrast_agent || header.has_contrast_agents;
    const auto positions = header.group_numbers(0x0020, 0x0032);
    const auto axes = header.group_numbers(0x0020, 0x0037);
    const auto spacings = header.group_numbers(0x0028, 0x0030);
    if (positions.empty() || axes.empty() || spacings.empty()) return;
    set_geometry(positions.front(), axes.front(), spacings.front(), slice);
    if (!slice.has_geometry || positions.size() != static_cast<std::size_t>(slice.frames)) return;
    for (const std::vector<double>& position : positions) {
        const bool sound = position.size() == 3 && std::isfinite(position[0]) &&
                           std::isfinite(position[1]) && std::isfinite(position[2]);
        if (!sound) return slice.frame_positions_mm.clear();
        slice.frame_positions_mm.emplace_back(position[0], position[1], position[2]);
    }
}

// A number that affects every Hounsfield unit. It may be absent; if it is present but invalid, the
// slice cannot be read.
double rescale_value(const DicomHeader& header, std::uint16_t element, const char* name,
                     double otherwise, std::string& problem) {
    const auto values = header.numbers_if_sound(0x0028, element);
    if (values && values->empty()) return otherwise;
    if (values && values->size() == 1 && std::isfinite(values->front())) return values->front();
    problem = std::string("has a rescale ") + name + " (0028," +
              (element == 0x1053 ? "1053" : "1052") + ") of \"" + header.text(0x0028, element) +
              "\", which is not one number";
    return otherwise;
}

void read_rescale(const DicomHeader& header, DicomSlice& slice) {
    slice.slope = rescale_value(header, 0x1053, "slope", 1.0, slice.problem);
    slice.intercept = rescale_value(header, 0x1052, "intercept", 0.0, slice.problem);
    slice.has_rescale =
        !header.text(0x0028, 0x1053).empty() || !header.text(0x0028, 0x1052).empty();
    if (header.has_modality_lut)
        slice.problem =
            "maps its values to Hounsfield units by a table (Modality LUT Sequence, 0028,3000), "
            "which this program does not read";
}

void read_photometric(const DicomHeader& header, DicomSlice& slice) {
    const std::string kind = header.text(0x0028, 0x0004);
    slice.inverted_display = kind == "MONOCHROME1";
    if (kind == "PALETTE COLOR")
        slice.problem = "is a picture in the colours of a palette (0028,0004), not a CT image";
    else if (!kind.empty() && kind != "MONOCHROME1" && kind != "MONOCHROME2")
        slice.problem = "is a colour picture (0028,0004 is \"" + kind + "\")";
}

// PS3.3 C.7.5.1.1.2: padding means "not measured", outside the round field of view.
void read_padding(const DicomHeader& header, DicomSlice& slice) {
    if (!header.has(0x0028, 0x0120)) return;
    const auto stored = [&](std::uint16_t element, int otherwise) {
        const int value = header.unsigned_short(0x0028, element, otherwise);
        return static_cast<double>(slice.is_signed ? static_cast<std::int16_t>(value) : value);
    };
    const int first = header.unsigned_short(0x0028, 0x0120, -1);
    if (first < 0) return;  // blank
    slice.padding = std::minmax(stored(0x0120, 0), stored(0x0121, first));
}

void read_pixel_format(const DicomHeader& header, DicomSlice& slice) {
    slice.bits_allocated = header.unsigned_short(0x0028, 0x0100);
    slice.bits_stored = header.unsigned_short(0x0028, 0x0101, slice.bits_allocated);
    slice.high_bit = header.unsigned_short(0x0028, 0x0102, slice.bits_stored - 1);
    slice.is_signed = header.unsigned_short(0x0028, 0x0103) != 0;
    slice.samples_per_pixel = header.unsigned_short(0x0028, 0x0002, 1);
    slice.big_endian = header.big_endian;
    slice.compressed = header.compressed;
    slice.pixel_offset = header.pixel_offset;
    slice.pixel_bytes = header.pixel_bytes;
    slice.transfer_syntax = header.transfer_syntax;
    slice.fragments = header.fragments;
    slice.deflated_at = header.deflated_at;
    read_rescale(header, slice);
    read_photometric(header, slice);
    read_padding(header, slice);
}

// Anonymised series may have lost their UID. Then all other values that are constant within a
// series distinguish examinations and series.
std::string series_key(const DicomHeader& header, const DicomSlice& slice) {
    const std::string uid = header.text(0x0020, 0x000e);
    if (!uid.empty()) return uid;
    std::ostringstream key;
    key << "no UID";
    constexpr std::pair<std::uint16_t, std::uint16_t> fields[] = {
        {0x0020, 0x000d},                                      // study UID
        {0x0008, 0x0020}, {0x0008, 0x0030}, {0x0008, 0x0021},  // study date, time; series date
        {0x0008, 0x0031}, {0x0008, 0x0060},                    // series time, modality
        {0x0020, 0x0052}, {0x0020, 0x0011}, {0x0008, 0x103e},  // frame of reference, number, name
        {0x0018, 0x1210}, {0x0018, 0x0050}, {0x0018, 0x0060},  // kernel, slice thickness, kV
        {0x0010, 0x0020}, {0x0028, 0x0030}};                   // patient, pixel spacing
    for (const auto& [group, element] : fields) key << '/' << header.text(group, element);
    key << '/' << slice.rows << '/' << slice.columns;
    for (const double cosine : header.numbers(0x0020, 0x0037))
        key << '/' << std::round(100.0 * cosine) + 0.0;  // adding 0 turns -0 into 0
    return key.str();
}

std::string description_of(const DicomHeader& header) {
    const std::string number = header.text(0x0020, 0x0011);
    const std::string description = header.text(0x0008, 0x103e);
    std::string text = number.empty() ? "series" : "series " + number;
    if (!description.empty()) text += " \"" + description + "\"";
    return text;
}

// Segmentation Storage, and Label Map Segmentation Storage, which the helper refuses later.
bool is_segmentation(const std::string& sop_class) {
    return sop_class == "1.2.840.10008.5.1.4.1.1.66.4" ||
           sop_class == "1.2.840.10008.5.1.4.1.1.66.7";
}

// Enhanced CT Image Storage, and Legacy Converted Enhanced CT Image Storage.
bool is_enhanced_ct(const std::string& sop_class) {
    return sop_class == "1.2.840.10008.5.1.4.1.1.2.1" || sop_class == "1.2.840.10008.5.1.4.1.1.2.2";
}

// 0 if it is missing or not a number.
double one_number(const DicomHeader& header, std::uint16_t group, std::uint16_t element) {
    const std::vector<double> values = header.numbers(group, element);
    return values.size() == 1 && std::isfinite(values[0]) ? values[0] : 0.0;
}

DicomSlice slice_of(const fs::path& file, const DicomHeader& header) {
    DicomSlice slice;
    slice.file = slice.pixel_file = file;
    slice.rows = header.unsigned_short(0x0028, 0x0010);
    slice.columns = header.unsigned_short(0x0028, 0x0011);
    slice.series_key = series_key(header, slice);
    slice.description = description_of(header);
    slice.modality = header.text(0x0008, 0x0060);
    slice.image_type = header.text(0x0008, 0x0008);
    slice.localizer = slice.image_type.find("LOCALIZER") != std::string::npos;
    const std::string sop_class = header.text(0x0008, 0x0016);
    slice.segmentation = is_segmentation(sop_class);
    slice.enhanced = is_enhanced_ct(sop_class) || slice.segmentation;
    slice.kernel = header.text(0x0018, 0x1210);
    slice.contrast_agent = !header.text(0x0018, 0x0010).empty();
    slice.acquisition = header.text(0x0020, 0x0012);
    const std::vector<double> frames = header.numbers(0x0028, 0x0008);
    if (!frames.empty() && frames[0] > 1.0)
        slice.frames = static_cast<int>(std::min(frames[0], 1e6));
    slice.stated_tilt_degrees = one_number(header, 0x0018, 0x1120);
    slice.stated_spacing_mm = std::abs(one_number(header, 0x0018, 0x0088));
    read_geometry(header, slice);
    if (slice.enhanced) read_functional_groups(header, slice);
    read_pixel_format(header, slice);
    return slice;
}

// Files that were not used. Damaged slices are named, because they would only show as a gap; other
// files without an image (reports, a DICOMDIR) are only counted.
struct Passed {
    std::size_t without_image = 0;
    std::vector<std::string> damaged;
};

// Collects the files below a folder. Anything that cannot be listed is named in the remarks, and
// the search continues.
class FileScan {
  public:
    explicit FileScan(ReadRemarks& remarks) : remarks_(remarks) {}

    std::vector<fs::path> files_below(const fs::path& folder) {
        std::error_code error;
        const fs::directory_iterator first(folder, error);
        if (error)
            throw InputError("cannot be opened (" + error.message() + ")", folder.string(),
                             "Check that the folder exists and may be read");
        folders_ = {folder};
        while (!folders_.empty()) {
            const fs::path next = std::move(folders_.back());
            folders_.pop_back();
            list(next);
        }
        std::ranges::sort(files_);
        return std::move(files_);
    }

  private:
    void list(const fs::path& folder) {
        std::error_code error;
        fs::directory_iterator entry(folder, error);
        while (!error && entry != fs::directory_iterator()) {
            look_at(*entry);
            entry.increment(error);
        }
        if (error)
            remarks_.push_back("The folder " + quoted_name(folder.string()) +
                               " could not be listed (" + error.message() +
                               "): files in it may be left out");
    }

    void look_at(const fs::directory_entry& entry) {
        std::error_code error;
        const fs::file_status status = entry.status(error);
        if (!fs::exists(status)) {
            const std::string reason =
                status.type() == fs::file_type::not_found ? "a link to nothing" : error.message();
            remarks_.push_back(quoted_name(entry.path().string()) + " was passed over (" + reason +
                               ")");
        } else if (fs::is_regular_file(status)) {
            files_.push_back(entry.path());
        } else if (fs::is_directory(status) && entry.is_symlink(error)) {
            remarks_.push_back("The linked folder " + quoted_name(entry.path().string()) +
                               " was not entered");
        } else if (fs::is_directory(status)) {
            folders_.push_back(entry.path());
        }
    }

    ReadRemarks& remarks_;
    std::vector<fs::path> folders_;  // still to be listed
    std::vector<fs::path> files_;
};

bool can_be_opened(const fs::path& file) {
    return std::ifstream(file, std::ios::binary).is_open();
}

}  // namespace

Vec3 DicomSlice::normal() const {
    return row_axis.cross(column_axis).normalized();
}

Mat3 DicomSlice::steps_mm(double slice_spacing_mm) const {
    Mat3 steps;
    steps.col(0) = row_axis.normalized() * column_spacing_mm;
    steps.col(1) = column_axis.normalized() * row_spacing_mm;
    steps.col(2) = normal() * slice_spacing_mm;
    return steps;
}

std::optional<DicomSlice> read_dicom_slice(const fs::path& file) {
    const std::optional<DicomHeader> header = read_dicom_header(file);
    if (!header || !header->has_pixels) return std::nullopt;
    return slice_of(file, *header);
}

std::vector<DicomSlice> find_dicom_slices(const fs::path& folder, Job& job, ReadRemarks& remarks) {
    const std::vector<fs::path> files = FileScan(remarks).files_below(folder);
    if (files.empty())
        throw InputError("is empty", folder.string(), "Choose the folder that holds the CT slices");
    std::vector<DicomSlice> slices;
    Passed passed;
    for (std::size_t i = 0; i < files.size(); ++i) {
        job.advance(0.5 * static_cast<double>(i) / static_cast<double>(files.size()));
        if (!can_be_opened(files[i]))
            remarks.push_back(quoted_name(files[i].string()) + " was passed over (" +
                              std::generic_category().message(errno) + ")");
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
        remarks.push_back(quoted_name(name) + " is a damaged DICOM file and was passed over");
    if (slices.empty())
        throw InputError("holds " + std::to_string(files.size()) + " files, but no DICOM images",
                         folder.string(), "Choose the folder that holds the CT slices");
    return slices;
}

}  // namespace hepatica
