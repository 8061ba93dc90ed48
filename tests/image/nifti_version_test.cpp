// SPDX-License-Identifier: GPL-3.0-or-later
// One image in the first and in the second version of NIfTI is one image, whatever says where it
// lies and in whichever byte order it is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

using namespace testing_support;

constexpr std::size_t data_of_first = 352, data_of_second = 544;

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

// A file of the second version with what a file of the first one says, field by field as nifti1.h
// and nifti2.h of the standard place them.
class SecondVersion {
  public:
    SecondVersion(const std::string& first, bool swapped)
        : first_(first), swapped_(swapped), bytes_(data_of_second, '\0') {
        put<std::int32_t>(0, 540);
        std::memcpy(bytes_.data() + 4, "n+2\0\r\n\032\n", 8);
        move<std::int16_t, std::int16_t>(70, 12);  // datatype
        move<std::int16_t, std::int16_t>(72, 14);  // bitpix
        for (std::size_t i = 0; i < 8; ++i) {
            move<std::int16_t, std::int64_t>(40 + 2 * i, 16 + 8 * i);  // dim
            move<float, double>(76 + 4 * i, 104 + 8 * i);              // pixdim
        }
        put<std::int64_t>(168, data_of_second);      // vox_offset
        move<float, double>(112, 176);               // scl_slope
        move<float, double>(116, 184);               // scl_inter
        move<std::int16_t, std::int32_t>(252, 344);  // qform_code
        move<std::int16_t, std::int32_t>(254, 348);  // sform_code
        for (std::size_t i = 0; i < 6; ++i)          // quatern_b to qoffset_z
            move<float, double>(256 + 4 * i, 352 + 8 * i);
        for (std::size_t i = 0; i < 12; ++i)  // srow_x, srow_y and srow_z
            move<float, double>(280 + 4 * i, 400 + 8 * i);
        move<std::uint8_t, std::int32_t>(123, 500);  // xyzt_units
        for (std::size_t at = data_of_first; at < first.size(); at += 2) {
            bytes_.append(2, '\0');
            move<std::int16_t, std::int16_t>(at, bytes_.size() - 2);
        }
    }
    const std::string& bytes() const { return bytes_; }

  private:
    template <class T>
    void put(std::size_t at, T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if (swapped_) std::reverse(std::begin(raw), std::end(raw));
        std::memcpy(bytes_.data() + at, raw, sizeof(T));
    }
    template <class From, class To>
    void move(std::size_t from, std::size_t to) {
        put(to, static_cast<To>(number_at<From>(first_, from)));
    }

    const std::string& first_;
    bool swapped_;
    std::string bytes_;
};

double sum_of(const Volume& volume) {
    return std::accumulate(volume.voxels.begin(), volume.voxels.end(), 0.0);
}

struct Orientation {
    const char* name;
    std::int16_t qform, sform;
};

TEST(NiftiVersions, SayTheSameOfOneImage) {
    const TemporaryFolder folder;
    Job job;
    const Volume volume = patterned_volume(turned_grid());
    write_nifti(folder / "first.nii", volume);
    std::string first = bytes_of_file(folder / "first.nii");
    ASSERT_EQ(number_at<float>(first, 108), data_of_first);
    const float slope = 2.0f, intercept = -30.0f;
    std::memcpy(first.data() + 112, &slope, 4);
    std::memcpy(first.data() + 116, &intercept, 4);
    for (const Orientation& by : {Orientation{"affine", 0, 1}, Orientation{"quaternion", 1, 0},
                                  Orientation{"none", 0, 0}}) {
        std::memcpy(first.data() + 252, &by.qform, 2);
        std::memcpy(first.data() + 254, &by.sform, 2);
        write_bytes(folder / "first.nii", first);
        const Volume expected = read_volume(folder / "first.nii", job);
        EXPECT_EQ(sum_of(expected),
                  2 * sum_of(volume) - 30.0 * static_cast<double>(volume.voxels.size()));
        for (const bool swapped : {false, true}) {
            write_bytes(folder / "second.nii", SecondVersion(first, swapped).bytes());
            const Volume read = read_volume(folder / "second.nii", job);
            EXPECT_EQ(read.voxels, expected.voxels) << by.name << " " << swapped;
            EXPECT_EQ(read.grid.dims, expected.grid.dims) << by.name;
            EXPECT_EQ(read.grid.spacing_mm, expected.grid.spacing_mm) << by.name;
            EXPECT_EQ(read.grid.origin_mm, expected.grid.origin_mm) << by.name;
            EXPECT_EQ(read.grid.direction, expected.grid.direction) << by.name;
        }
    }
}

// Its first 348 bytes are as many as the whole header of the first version has.
TEST(NiftiVersions, SayThatTheHeaderOfTheSecondIsCut) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "first.nii", patterned_volume(turned_grid()));
    const std::string first = bytes_of_file(folder / "first.nii");
    const auto said_of_bytes = [&](bool swapped, std::size_t bytes) {
        write_bytes(folder / "second.nii", SecondVersion(first, swapped).bytes().substr(0, bytes));
        return refusal([&] { read_volume(folder / "second.nii", job); });
    };
    for (const bool swapped : {false, true}) {
        for (const std::size_t bytes : {348u, 400u, 539u})
            EXPECT_NE(said_of_bytes(swapped, bytes).find("is cut within its NIfTI-2 header"),
                      std::string::npos)
                << said_of_bytes(swapped, bytes);
        EXPECT_NE(said_of_bytes(swapped, data_of_second).find("which a file of"), std::string::npos)
            << "the header is whole";
    }
}

}  // namespace
}  // namespace hepatica
