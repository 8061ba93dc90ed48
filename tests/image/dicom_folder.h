// SPDX-License-Identifier: GPL-3.0-or-later
// A DICOM series written by the program, whose tags a test may then bend.
#pragma once

#include <gdcmDataSet.h>
#include <gdcmReader.h>
#include <gdcmWriter.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica::testing_support {

// A folder with one series of nine slices, slice_0001.dcm to slice_0009.dcm.
class DicomFolder {
  public:
    explicit DicomFolder(const Volume& volume = patterned_volume(small_grid())) : volume_(volume) {
        Job job;
        write_dicom_series(path(), volume_, {}, job);
    }

    std::filesystem::path path() const { return folder_ / "ct"; }
    std::filesystem::path slice(int number) const {
        char name[32];
        std::snprintf(name, sizeof name, "slice_%04d.dcm", number);
        return path() / name;
    }
    const Volume& volume() const { return volume_; }

    // Replaces the value of a tag, as text, in one slice.
    void edit(int number, gdcm::Tag tag, const std::string& value) const {
        edit_file(slice(number), tag, value);
    }
    void edit_all(gdcm::Tag tag, const std::string& value) const {
        for (int i = 1; i <= volume_.grid.dims[2]; ++i) edit(i, tag, value);
    }
    static void edit_file(const std::filesystem::path& file, gdcm::Tag tag, std::string value) {
        if (value.size() % 2 != 0) value += ' ';
        gdcm::Reader reader;
        reader.SetFileName(file.c_str());
        ASSERT_TRUE(reader.Read());
        gdcm::DataSet& data = reader.GetFile().GetDataSet();
        gdcm::DataElement element(tag);
        element.SetVR(data.FindDataElement(tag) ? data.GetDataElement(tag).GetVR()
                                                : gdcm::VR(gdcm::VR::LO));
        element.SetByteValue(value.data(), static_cast<std::uint32_t>(value.size()));
        data.Replace(element);
        gdcm::Writer writer;
        writer.CheckFileMetaInformationOff();
        writer.SetFile(reader.GetFile());
        writer.SetFileName(file.c_str());
        ASSERT_TRUE(writer.Write());
    }

    Volume read(ReadRemarks* remarks = nullptr) const {
        Job job;
        return read_volume(path(), job, remarks);
    }
    std::string refusal_of_folder() const {
        return refusal([&] { read(); });
    }

  private:
    TemporaryFolder folder_;
    Volume volume_;
};

inline bool mentions(const ReadRemarks& remarks, const std::string& text) {
    return std::ranges::any_of(
        remarks, [&](const std::string& r) { return r.find(text) != std::string::npos; });
}

inline const gdcm::Tag position(0x0020, 0x0032);
inline const gdcm::Tag orientation(0x0020, 0x0037);
inline const gdcm::Tag pixel_spacing(0x0028, 0x0030);
inline const gdcm::Tag series_uid(0x0020, 0x000e);
inline const gdcm::Tag study_uid(0x0020, 0x000d);
inline const gdcm::Tag series_number(0x0020, 0x0011);
inline const gdcm::Tag modality(0x0008, 0x0060);
inline const gdcm::Tag image_type(0x0008, 0x0008);
inline const gdcm::Tag frames(0x0028, 0x0008);
inline const gdcm::Tag slope(0x0028, 0x1053);
inline const gdcm::Tag intercept(0x0028, 0x1052);

}  // namespace hepatica::testing_support
