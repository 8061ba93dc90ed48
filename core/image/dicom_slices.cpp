// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/dicom_slices.h"

#include <gdcmDataSet.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/image/header_text.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::string text_of(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element) {
    const gdcm::Tag tag(group, element);
    if (!data.FindDataElement(tag)) return "";
    const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
    if (value == nullptr || value->GetPointer() == nullptr) return "";
    return trimmed({value->GetPointer(), value->GetLength()});
}

// The numbers of a decimal string, which backslashes part.
std::vector<double> numbers_of(const gdcm::DataSet& data, std::uint16_t group,
                               std::uint16_t element) {
    std::string text = text_of(data, group, element);
    std::ranges::replace(text, '\\', ' ');
    return numbers(text).value_or(std::vector<double>{});
}

int unsigned_short(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element) {
    const gdcm::Tag tag(group, element);
    if (!data.FindDataElement(tag)) return 0;
    const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
    if (value == nullptr || value->GetLength() < 2) return 0;
    const auto* bytes = reinterpret_cast<const unsigned char*>(value->GetPointer());
    return bytes[0] | bytes[1] << 8;
}

void read_geometry(const gdcm::DataSet& data, DicomSlice& slice) {
    const std::vector<double> position = numbers_of(data, 0x0020, 0x0032);
    const std::vector<double> axes = numbers_of(data, 0x0020, 0x0037);
    const std::vector<double> spacing = numbers_of(data, 0x0028, 0x0030);
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

// Anonymised series may have lost their UID: study, number and description then part them.
std::string series_key(const gdcm::DataSet& data) {
    const std::string uid = text_of(data, 0x0020, 0x000e);
    if (!uid.empty()) return uid;
    return "no UID/" + text_of(data, 0x0020, 0x000d) + "/" + text_of(data, 0x0020, 0x0011) + "/" +
           text_of(data, 0x0008, 0x103e);
}

std::string description_of(const gdcm::DataSet& data) {
    const std::string number = text_of(data, 0x0020, 0x0011);
    const std::string description = text_of(data, 0x0008, 0x103e);
    std::string text = number.empty() ? "series" : "series " + number;
    if (!description.empty()) text += " \"" + description + "\"";
    return text;
}

std::optional<DicomSlice> read_slice(const fs::path& file) {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    const gdcm::Tag pixel_data(0x7fe0, 0x0010);
    try {
        if (!reader.ReadUpToTag(pixel_data)) return std::nullopt;
    } catch (const std::exception&) {
        return std::nullopt;
    }
    const gdcm::DataSet& data = reader.GetFile().GetDataSet();
    DicomSlice slice;
    slice.file = file;
    slice.rows = unsigned_short(data, 0x0028, 0x0010);
    slice.columns = unsigned_short(data, 0x0028, 0x0011);
    if (slice.rows == 0 || slice.columns == 0) return std::nullopt;  // a report, a DICOMDIR ...
    slice.series_key = series_key(data);
    slice.description = description_of(data);
    slice.modality = text_of(data, 0x0008, 0x0060);
    slice.localizer = text_of(data, 0x0008, 0x0008).find("LOCALIZER") != std::string::npos;
    const std::vector<double> frames = numbers_of(data, 0x0028, 0x0008);
    if (!frames.empty() && frames[0] > 1.0)
        slice.frames = static_cast<int>(std::min(frames[0], 1e6));
    read_geometry(data, slice);
    return slice;
}

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

bool is_dicom_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 132> head{};
    in.read(head.data(), head.size());
    if (in.gcount() == 132 && std::string_view(head.data() + 128, 4) == "DICM") return true;
    // Old files have no preamble: they begin with a tag of group 0002 or 0008.
    if (in.gcount() < 8 || (head[0] != 2 && head[0] != 8) || head[1] != 0) return false;
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    return reader.CanRead();
}

std::vector<DicomSlice> find_dicom_slices(const fs::path& folder, Job& job, ReadRemarks& remarks) {
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    const std::vector<fs::path> files = files_below(folder);
    if (files.empty())
        throw InputError("is empty", folder.string(), "Choose the folder that holds the CT slices");
    std::vector<DicomSlice> slices;
    std::size_t unreadable = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        job.advance(0.5 * static_cast<double>(i) / static_cast<double>(files.size()));
        if (!is_dicom_file(files[i])) continue;
        if (auto slice = read_slice(files[i]))
            slices.push_back(std::move(*slice));
        else if (lower_case(files[i].filename().string()) != "dicomdir")
            ++unreadable;
    }
    if (unreadable > 0)
        remarks.push_back(std::to_string(unreadable) +
                          " DICOM files hold no image and were passed over");
    if (slices.empty())
        throw InputError("holds " + std::to_string(files.size()) + " files, but no DICOM images",
                         folder.string(), "Choose the folder that holds the CT slices");
    return slices;
}

}  // namespace hepatica
