// SPDX-License-Identifier: GPL-3.0-or-later
// An enhanced multi-frame CT as tests want it, written by GDCM: the program reads such files by
// another library. Each frame has a rescale of its own, and the frames stand in a scrambled order.
#pragma once

#include <gdcmDataSet.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica::testing_support {

inline void put(gdcm::DataSet& data, const gdcm::Tag& tag, const gdcm::VR& vr, std::string value) {
    if (value.size() % 2 != 0) value += vr == gdcm::VR::UI ? '\0' : ' ';
    gdcm::DataElement element(tag);
    element.SetVR(vr);
    element.SetByteValue(value.data(), static_cast<std::uint32_t>(value.size()));
    data.Replace(element);
}

inline std::string word_of(int value) {
    return {static_cast<char>(value & 0xff), static_cast<char>((value >> 8) & 0xff)};
}

// Numbers as DICOM writes them, parted by backslashes.
inline std::string number_list(std::initializer_list<double> numbers) {
    std::string list;
    for (const double number : numbers) {
        char text[32];
        std::snprintf(text, sizeof text, "%s%.10g", list.empty() ? "" : "\\", number);
        list += text;
    }
    return list;
}

inline void put_sequence(gdcm::DataSet& data, const gdcm::Tag& tag,
                         const std::vector<gdcm::DataSet>& items) {
    const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = new gdcm::SequenceOfItems();
    sequence->SetLengthToUndefined();
    for (const gdcm::DataSet& content : items) {
        gdcm::Item item;
        item.SetVLToUndefined();
        item.SetNestedDataSet(content);
        sequence->AddItem(item);
    }
    gdcm::DataElement element(tag);
    element.SetVR(gdcm::VR::SQ);
    element.SetValue(*sequence);
    element.SetVLToUndefined();
    data.Replace(element);
}

inline const gdcm::Tag per_frame_groups(0x5200, 0x9230);
inline const gdcm::Tag frame_content(0x0020, 0x9111);
inline const gdcm::Tag plane_position(0x0020, 0x9113);
inline const gdcm::Tag plane_orientation(0x0020, 0x9116);
inline const gdcm::Tag pixel_measures(0x0028, 0x9110);
inline const gdcm::Tag pixel_values(0x0028, 0x9145);

struct EnhancedCt {
    explicit EnhancedCt(Volume what) : volume(std::move(what)) {
        for (int z = 0; z < volume.grid.dims[2]; ++z)
            corners_mm.push_back(volume.grid.to_mm(0, 0, z));
    }

    // Slice of the volume that is shown by a frame, both from 0.
    int slice_of(int frame) const {
        const int count = volume.grid.dims[2];
        return (frame * 2 + 1) % count;  // each once where the count is odd
    }
    static int intercept_of(int frame) { return -1024 - frame; }

    std::vector<std::int16_t> stored(int frame) const {
        const std::size_t count = volume.grid.offset(0, 0, 1);
        std::vector<std::int16_t> values(count);
        const auto from =
            volume.voxels.begin() + static_cast<std::ptrdiff_t>(count) * slice_of(frame);
        std::transform(
            from, from + static_cast<std::ptrdiff_t>(count), values.begin(),
            [&](std::int16_t hu) { return static_cast<std::int16_t>(hu - intercept_of(frame)); });
        return values;
    }

    gdcm::DataSet group_of(int frame) const {
        const Vec3& p = corners_mm[static_cast<std::size_t>(slice_of(frame))];
        gdcm::DataSet place, values, content, group;
        put(place, gdcm::Tag(0x0020, 0x0032), gdcm::VR::DS, number_list({p.x(), p.y(), p.z()}));
        put_sequence(group, plane_position, {place});
        put(values, gdcm::Tag(0x0028, 0x1052), gdcm::VR::DS, std::to_string(intercept_of(frame)));
        put(values, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, "1");
        put(values, gdcm::Tag(0x0028, 0x1054), gdcm::VR::LO, "HU");
        put_sequence(group, pixel_values, {values});
        put(content, gdcm::Tag(0x0020, 0x9056), gdcm::VR::SH, "1");
        put_sequence(group, frame_content, {content});
        if (edit_group) edit_group(group, frame);
        return group;
    }

    void describe(gdcm::DataSet& data) const {
        const Grid& grid = volume.grid;
        put(data, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2.1");
        put(data, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, "2.25.77");
        put(data, gdcm::Tag(0x0008, 0x0008), gdcm::VR::CS, "ORIGINAL\\PRIMARY\\VOLUME\\NONE");
        put(data, gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, "CT");
        put(data, gdcm::Tag(0x0008, 0x103e), gdcm::VR::LO, "portal venous, enhanced");
        put(data, gdcm::Tag(0x0020, 0x000d), gdcm::VR::UI, "2.25.7");
        put(data, gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, "2.25.78");
        put(data, gdcm::Tag(0x0028, 0x0002), gdcm::VR::US, word_of(1));
        put(data, gdcm::Tag(0x0028, 0x0004), gdcm::VR::CS, "MONOCHROME2");
        put(data, gdcm::Tag(0x0028, 0x0008), gdcm::VR::IS, std::to_string(grid.dims[2]));
        put(data, gdcm::Tag(0x0028, 0x0010), gdcm::VR::US, word_of(grid.dims[1]));
        put(data, gdcm::Tag(0x0028, 0x0011), gdcm::VR::US, word_of(grid.dims[0]));
        put(data, gdcm::Tag(0x0028, 0x0100), gdcm::VR::US, word_of(16));
        put(data, gdcm::Tag(0x0028, 0x0101), gdcm::VR::US, word_of(16));
        put(data, gdcm::Tag(0x0028, 0x0102), gdcm::VR::US, word_of(15));
        put(data, gdcm::Tag(0x0028, 0x0103), gdcm::VR::US, word_of(1));
        gdcm::DataSet axes, measures, shared;
        const Vec3 row = grid.direction.col(0), column = grid.direction.col(1);
        put(axes, gdcm::Tag(0x0020, 0x0037), gdcm::VR::DS,
            number_list({row.x(), row.y(), row.z(), column.x(), column.y(), column.z()}));
        put(measures, gdcm::Tag(0x0028, 0x0030), gdcm::VR::DS,
            number_list({grid.spacing_mm[1], grid.spacing_mm[0]}));
        put_sequence(shared, plane_orientation, {axes});
        put_sequence(shared, pixel_measures, {measures});
        put_sequence(data, gdcm::Tag(0x5200, 0x9229), {shared});
        std::vector<gdcm::DataSet> groups;
        for (int frame = 0; frame < grid.dims[2]; ++frame) groups.push_back(group_of(frame));
        put_sequence(data, per_frame_groups, groups);
    }

    void put_plain_pixels(gdcm::DataSet& data) const {
        std::string bytes;
        for (int frame = 0; frame < volume.grid.dims[2]; ++frame) {
            const std::vector<std::int16_t> values = stored(frame);
            bytes.append(reinterpret_cast<const char*>(values.data()), 2 * values.size());
        }
        put(data, gdcm::Tag(0x7fe0, 0x0010), gdcm::VR::OW, bytes);
    }

    void write(
        const std::filesystem::path& file,
        gdcm::TransferSyntax::TSType syntax = gdcm::TransferSyntax::ExplicitVRLittleEndian) const {
        gdcm::Writer writer;
        gdcm::DataSet& data = writer.GetFile().GetDataSet();
        describe(data);
        if (pixels)
            pixels(*this, data);
        else
            put_plain_pixels(data);
        if (edit_data) edit_data(data);
        writer.GetFile().GetHeader().SetDataSetTransferSyntax(syntax);
        writer.SetFileName(file.c_str());
        ASSERT_TRUE(writer.Write());
    }

    Volume volume;
    std::vector<Vec3> corners_mm;  // of the slices of the volume
    std::function<void(gdcm::DataSet& group, int frame)> edit_group;
    std::function<void(gdcm::DataSet& data)> edit_data;
    std::function<void(const EnhancedCt& ct, gdcm::DataSet& data)> pixels;
};

}  // namespace hepatica::testing_support
