// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "core/base/error.h"
#include "render/palette.h"
#include "tests/support/comma_locale.h"
#include "tests/support/small_disk.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

Picture chessboard(int width, int height) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool white = (x / 8 + y / 8) % 2 == 0;
            for (int c = 0; c < 3; ++c) picture.rgb.push_back(white ? 200 : std::uint8_t(20 * c));
        }
    }
    return picture;
}

TEST(Picture, survives_png_under_a_name_that_is_not_ascii) {
    const fs::path file = fs::temp_directory_path() / u8"hepatica_Lebergefäß_肝.png";
    const Picture picture = chessboard(37, 21);
    write_png(file, picture);
    const Picture read = read_png(file);
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 21);
    EXPECT_EQ(read.rgb, picture.rgb);
    fs::remove(file);
}

TEST(Picture, names_the_file_that_cannot_be_written_or_read) {
    EXPECT_THROW(write_png("/proc/hepatica/a.png", chessboard(4, 4)), InputError);
    EXPECT_THROW(read_png("/proc/hepatica/a.png"), InputError);
    const fs::path text = fs::temp_directory_path() / "hepatica_no_picture.png";
    std::ofstream(text) << "not a picture";
    EXPECT_THROW(read_png(text), InputError);
    fs::remove(text);
}

// Our message names the file. The PNG library has a line of its own.
TEST(Picture, is_refused_on_a_full_disk_without_a_word_of_vtk) {
    Picture picture = chessboard(100, 100);
    std::mt19937 random(1);  // nothing compresses that
    for (std::uint8_t& value : picture.rgb) value = static_cast<std::uint8_t>(random());
    testing::internal::CaptureStderr();
    {
        const test::DiskOf full(2000);
        EXPECT_THROW(write_png(fs::temp_directory_path() / "hepatica_full.png", picture),
                     InputError);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(said.find("ERR|"), std::string::npos) << said;
}

TEST(Palette, the_drugs_map_rises_in_lightness) {
    double last = 0.0;
    for (int i = 0; i <= 50; ++i) {
        const Colour c = palette::drug(i / 50.0);
        const double luminance = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        EXPECT_GT(luminance, last);
        last = luminance;
    }
    EXPECT_EQ(palette::drug(-3.0), palette::drug(0.0));
    EXPECT_EQ(palette::drug(7.0), palette::drug(1.0));
}

TEST(Palette, warns_from_half_of_the_limit_on_and_is_red_at_it) {
    const Colour vessel = palette::vessel_system(VascularSystem::portal);
    EXPECT_EQ(palette::warning(vessel, 0.0), vessel);
    EXPECT_EQ(palette::warning(vessel, 0.49), vessel);
    double green = 1.0;
    for (const double load : {0.7, 0.8, 0.9, 1.0}) {
        const Colour now = palette::warning(vessel, load);
        EXPECT_GT(now[0], 0.9);
        EXPECT_LT(now[1], green) << load;
        green = now[1];
    }
    EXPECT_EQ(palette::warning(vessel, 1.0), palette::warning(vessel, 50.0));
}

TEST(Palette, shader_code_has_decimal_points_whatever_the_locale) {
    const std::string plain = palette::drug_glsl();
    EXPECT_NE(plain.find("0.6"), std::string::npos);
    const test::CommaLocale comma;
    EXPECT_EQ(palette::drug_glsl(), plain);
}

}  // namespace
}  // namespace hepatica
