// SPDX-License-Identifier: GPL-3.0-or-later
// Writes CT Image Storage (DICOM PS3.3 A.3) through GDCM.
#include <gdcmAttribute.h>
#include <gdcmDataSet.h>
#include <gdcmFileMetaInformation.h>
#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/image/volume_writer.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr const char* ct_image_storage = "1.2.840.10008.5.1.4.1.1.2";

// A decimal string of at most 16 characters, as the standard requires.
std::string decimal(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.10g", value == 0.0 ? 0.0 : value);
    return text.data();
}

// Sets a text value, padded to an even length by a null for UIDs, else by a space.
void set(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element, const gdcm::VR& vr,
         std::string value) {
    if (value.size() % 2 != 0) value += vr == gdcm::VR::UI ? '\0' : ' ';
    gdcm::DataElement item(gdcm::Tag(group, element));
    item.SetVR(vr);
    item.SetByteValue(value.data(), static_cast<std::uint32_t>(value.size()));
    data.Replace(item);
}

void set_short(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element,
               std::uint16_t value) {
    const std::array<char, 2> bytes{static_cast<char>(value & 0xff), static_cast<char>(value >> 8)};
    gdcm::DataElement item(gdcm::Tag(group, element));
    item.SetVR(gdcm::VR::US);
    item.SetByteValue(bytes.data(), 2);
    data.Replace(item);
}

// UIDs under 2.25, the root that needs no registration: 2.25.<a number of up to 128 bits>, here a
// hash of the image and its description.
class UidMaker {
  public:
    UidMaker(const Volume& volume, const DicomSeriesInfo& info) {
        hasher_.add(std::span<const std::int16_t>(volume.voxels));
        hasher_.add(std::span<const int>(volume.grid.dims));
        for (const std::string* text :
             {&info.patient_name, &info.patient_id, &info.series_description, &info.study_date})
            hasher_.add_bytes(text->data(), text->size());
    }

    std::string make(std::uint32_t what, std::uint32_t number = 0) const {
        std::array<std::uint64_t, 2> words{};
        for (std::uint32_t half = 0; half < 2; ++half) {
            Hasher hasher = hasher_;
            const std::array<std::uint32_t, 3> key{what, number, half};
            hasher.add(std::span<const std::uint32_t>(key));
            words[half] = hasher.value();
        }
        // The bits that mark a UUID of version 8 (RFC 9562).
        words[0] = (words[0] & ~0xf000ULL) | 0x8000ULL;
        words[1] = (words[1] & ~(3ULL << 62)) | (1ULL << 63);
        return "2.25." + decimal_digits(words);
    }

  private:
    static std::string decimal_digits(const std::array<std::uint64_t, 2>& words) {
        std::array<std::uint32_t, 4> limbs{
            static_cast<std::uint32_t>(words[0] >> 32), static_cast<std::uint32_t>(words[0]),
            static_cast<std::uint32_t>(words[1] >> 32), static_cast<std::uint32_t>(words[1])};
        std::string digits;
        while (limbs != std::array<std::uint32_t, 4>{}) {
            std::uint64_t rest = 0;
            for (std::uint32_t& limb : limbs) {
                rest = rest << 32 | limb;
                limb = static_cast<std::uint32_t>(rest / 10);
                rest %= 10;
            }
            digits.insert(digits.begin(), static_cast<char>('0' + rest));
        }
        return digits;
    }

    Hasher hasher_;
};

enum Uid : std::uint32_t { study = 1, series, frame_of_reference, instance };

void describe_patient_and_study(gdcm::DataSet& data, const DicomSeriesInfo& info,
                                const UidMaker& uids) {
    set(data, 0x0008, 0x0005, gdcm::VR::CS, "ISO_IR 192");
    set(data, 0x0010, 0x0010, gdcm::VR::PN, info.patient_name);
    set(data, 0x0010, 0x0020, gdcm::VR::LO, info.patient_id);
    set(data, 0x0010, 0x0030, gdcm::VR::DA, "");
    set(data, 0x0010, 0x0040, gdcm::VR::CS, "O");
    set(data, 0x0020, 0x000d, gdcm::VR::UI, uids.make(Uid::study));
    set(data, 0x0008, 0x0020, gdcm::VR::DA, info.study_date);
    set(data, 0x0008, 0x0030, gdcm::VR::TM, "120000");
    set(data, 0x0008, 0x0090, gdcm::VR::PN, "");
    set(data, 0x0020, 0x0010, gdcm::VR::SH, "1");
    set(data, 0x0008, 0x0050, gdcm::VR::SH, "");
    set(data, 0x0008, 0x1030, gdcm::VR::LO, "Hepatica");
}

void describe_series(gdcm::DataSet& data, const DicomSeriesInfo& info, const UidMaker& uids) {
    set(data, 0x0008, 0x0060, gdcm::VR::CS, "CT");
    set(data, 0x0020, 0x000e, gdcm::VR::UI, uids.make(Uid::series));
    set(data, 0x0020, 0x0011, gdcm::VR::IS, "1");
    set(data, 0x0008, 0x103e, gdcm::VR::LO, info.series_description);
    set(data, 0x0018, 0x0015, gdcm::VR::CS, "ABDOMEN");
    set(data, 0x0018, 0x5100, gdcm::VR::CS, "HFS");
    set(data, 0x0020, 0x0052, gdcm::VR::UI, uids.make(Uid::frame_of_reference));
    set(data, 0x0020, 0x1040, gdcm::VR::LO, "");
    set(data, 0x0008, 0x0070, gdcm::VR::LO, "Hepatica");
    set(data, 0x0018, 0x0060, gdcm::VR::DS, "120");
    set(data, 0x0020, 0x0012, gdcm::VR::IS, "1");
}

void describe_pixels(gdcm::DataSet& data, const Grid& grid, const DicomSeriesInfo& info) {
    set(data, 0x0008, 0x0008, gdcm::VR::CS, "DERIVED\\SECONDARY\\AXIAL");
    set_short(data, 0x0028, 0x0002, 1);
    set(data, 0x0028, 0x0004, gdcm::VR::CS, "MONOCHROME2");
    set_short(data, 0x0028, 0x0010, static_cast<std::uint16_t>(grid.dims[1]));
    set_short(data, 0x0028, 0x0011, static_cast<std::uint16_t>(grid.dims[0]));
    set_short(data, 0x0028, 0x0100, 16);
    set_short(data, 0x0028, 0x0101, 16);
    set_short(data, 0x0028, 0x0102, 15);
    set_short(data, 0x0028, 0x0103, 1);
    set(data, 0x0028, 0x1052, gdcm::VR::DS, "0");
    set(data, 0x0028, 0x1053, gdcm::VR::DS, "1");
    set(data, 0x0028, 0x1054, gdcm::VR::LO, "HU");
    set(data, 0x0028, 0x1050, gdcm::VR::DS, decimal(info.window_centre_hu));
    set(data, 0x0028, 0x1051, gdcm::VR::DS, decimal(info.window_width_hu));
    set(data, 0x0028, 0x0030, gdcm::VR::DS,
        decimal(grid.spacing_mm[1]) + "\\" + decimal(grid.spacing_mm[0]));
    set(data, 0x0018, 0x0050, gdcm::VR::DS, decimal(grid.spacing_mm[2]));
    std::string axes;
    for (int a = 0; a < 2; ++a)
        for (int i = 0; i < 3; ++i)
            axes += (axes.empty() ? "" : "\\") + decimal(grid.direction(i, a));
    set(data, 0x0020, 0x0037, gdcm::VR::DS, axes);
}

void describe_slice(gdcm::DataSet& data, const Grid& grid, int z, const UidMaker& uids) {
    const Vec3 p = grid.to_mm(0, 0, z);
    set(data, 0x0008, 0x0016, gdcm::VR::UI, ct_image_storage);
    set(data, 0x0008, 0x0018, gdcm::VR::UI,
        uids.make(Uid::instance, static_cast<std::uint32_t>(z)));
    set(data, 0x0020, 0x0013, gdcm::VR::IS, std::to_string(z + 1));
    set(data, 0x0020, 0x0032, gdcm::VR::DS,
        decimal(p[0]) + "\\" + decimal(p[1]) + "\\" + decimal(p[2]));
    set(data, 0x0020, 0x1041, gdcm::VR::DS, decimal(p.dot(grid.direction.col(2))));
}

void set_pixels(gdcm::DataSet& data, const Volume& volume, int z) {
    const std::size_t count = volume.grid.offset(0, 0, 1);
    gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
    pixels.SetVR(gdcm::VR::OW);
    pixels.SetByteValue(
        reinterpret_cast<const char*>(volume.voxels.data() + volume.grid.offset(0, 0, z)),
        static_cast<std::uint32_t>(count * sizeof(std::int16_t)));
    data.Replace(pixels);
}

// Through memory: GDCM ends the program where its stream fails amid an element, as on a full disk.
void write_slice(gdcm::Writer& writer, const fs::path& temporary, const fs::path& file) {
    std::ostringstream bytes;
    writer.SetStream(bytes);
    bool written = writer.Write();
    std::ofstream out(temporary, std::ios::binary);
    out << std::move(bytes).str();
    written = written && out.flush();
    if (!written)
        throw InputError("cannot be written", file.string(), "Check that the disk has free space");
}

}  // namespace

bool is_written_slice(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with("slice_") && name.ends_with(".dcm");
}

void write_dicom_series(const fs::path& folder, const Volume& volume, const DicomSeriesInfo& info,
                        Job& job) {
    gdcm::Trace::WarningOff();
    job.begin_stage("Writing the DICOM series");
    const Grid& grid = volume.grid;
    for (int a = 0; a < 2; ++a)
        if (grid.dims[a] > 65535)
            throw InputError("cannot hold " + std::to_string(grid.dims[a]) + " pixels in a row",
                             folder.string(), "Crop the image first");
    const UidMaker uids(volume, info);
    const auto write_slices = [&](const fs::path& temporary) {
        for (int z = 0; z < grid.dims[2]; ++z) {
            job.advance(static_cast<double>(z) / grid.dims[2]);
            gdcm::Writer writer;
            gdcm::DataSet& data = writer.GetFile().GetDataSet();
            describe_patient_and_study(data, info, uids);
            describe_series(data, info, uids);
            describe_pixels(data, grid, info);
            describe_slice(data, grid, z, uids);
            set_pixels(data, volume, z);
            writer.GetFile().GetHeader().SetDataSetTransferSyntax(
                gdcm::TransferSyntax::ExplicitVRLittleEndian);
            std::array<char, 32> name{};
            std::snprintf(name.data(), name.size(), "slice_%04d.dcm", z + 1);
            write_slice(writer, temporary / name.data(), folder / name.data());
        }
    };
    renew_folder_atomically(folder, write_slices, is_written_slice);
}

}  // namespace hepatica
