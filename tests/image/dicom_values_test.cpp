// SPDX-License-Identifier: GPL-3.0-or-later
// From stored values to Hounsfield units: what a header says of them is honoured or refused.
#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

using namespace testing_support;

const gdcm::Tag bits_stored(0x0028, 0x0101);
const gdcm::Tag high_bit(0x0028, 0x0102);
const gdcm::Tag is_signed(0x0028, 0x0103);
const gdcm::Tag photometric(0x0028, 0x0004);
const gdcm::Tag padding_value(0x0028, 0x0120);
const gdcm::Tag padding_limit(0x0028, 0x0121);
const gdcm::Tag modality_lut(0x0028, 0x3000);
const gdcm::Tag pixels(0x7fe0, 0x0010);

std::string word(int value) {
    return {static_cast<char>(value & 0xff), static_cast<char>((value >> 8) & 0xff)};
}

// It counted as absent once: everything was off by 1024 HU, without a word.
TEST(DicomRescale, ThatIsNoNumberIsRefusedByFileTagAndValue) {
    for (const auto& [tag, name] :
         {std::pair{intercept, "intercept (0028,1052)"}, std::pair{slope, "slope (0028,1053)"}})
        for (const char* value : {"-1024,0", "abc", "1\\2", "nan"}) {
            const DicomFolder folder;
            folder.edit(4, tag, value);
            const std::string message = folder.refusal_of_folder();
            EXPECT_NE(message.find("slice_0004.dcm"), std::string::npos) << message;
            EXPECT_NE(message.find(name), std::string::npos) << message;
            EXPECT_NE(message.find(value), std::string::npos) << message;
        }
}

TEST(DicomRescale, ThatIsMissingIsSaidWhereValuesHaveNoSign) {
    const DicomFolder folder;
    for (int i = 1; i <= 9; ++i) {
        folder.edit(i, slope, "");
        folder.edit(i, intercept, "");
        folder.edit(i, is_signed, word(0));
    }
    ReadRemarks remarks;
    folder.read(&remarks);
    EXPECT_TRUE(mentions(remarks, "9 slices state no rescale")) << remarks.size();
}

// They were flattened without a word.
TEST(DicomRescale, ToValuesBeyondSixteenBitsIsSaidWithTheirNumber) {
    Volume volume(small_grid(), 40);
    volume.voxels[0] = 400;
    volume.voxels[5] = 327;
    volume.voxels[700] = -400;
    const DicomFolder folder(volume);
    folder.edit_all(slope, "100");
    ReadRemarks remarks;
    const Volume read = folder.read(&remarks);
    EXPECT_EQ(read.voxels[0], 32767);
    EXPECT_EQ(read.voxels[5], 32700);
    EXPECT_EQ(read.voxels[700], -32768);
    EXPECT_EQ(read.voxels[1], 4000);
    EXPECT_TRUE(mentions(remarks, "2 values lie outside 16 bits and were clamped"));
}

// Twelve bits in the upper part of the word, with an overlay in the lower.
TEST(DicomHighBit, OfBitsThatDoNotBeginAtTheLowestIsHonoured) {
    Volume low_values(small_grid());
    for (std::size_t i = 0; i < low_values.voxels.size(); ++i)
        low_values.voxels[i] = static_cast<std::int16_t>(i % 2000) - 1000;
    Volume shifted = low_values;
    for (std::int16_t& v : shifted.voxels) v = static_cast<std::int16_t>(v * 16 + 5);
    const DicomFolder folder(shifted);
    folder.edit_all(bits_stored, word(12));
    folder.edit_all(high_bit, word(15));
    EXPECT_EQ(folder.read().voxels, low_values.voxels);
}

TEST(DicomHighBit, ThatCannotBeIsRefused) {
    for (const int bit : {3, 16, 40}) {
        const DicomFolder folder;
        folder.edit_all(bits_stored, word(12));
        folder.edit_all(high_bit, word(bit));
        const std::string message = folder.refusal_of_folder();
        EXPECT_NE(message.find("high bit " + std::to_string(bit)), std::string::npos) << message;
    }
}

TEST(DicomPixels, InColoursOrAPaletteAreRefusedInWords) {
    const DicomFolder palette;
    palette.edit_all(photometric, "PALETTE COLOR");
    EXPECT_NE(palette.refusal_of_folder().find("palette"), std::string::npos);
    const DicomFolder colour;
    colour.edit_all(photometric, "YBR_FULL");
    EXPECT_NE(colour.refusal_of_folder().find("colour picture"), std::string::npos);
}

// PS3.3 C.7.6.3.1.2: MONOCHROME1 says how values are shown, not what they mean.
TEST(DicomPixels, ShownInvertedAreReadAsTheyAreAndItIsSaid) {
    const DicomFolder folder;
    folder.edit_all(photometric, "MONOCHROME1");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    EXPECT_TRUE(mentions(remarks, "MONOCHROME1"));
}

TEST(DicomPixels, MappedByATableAreRefusedInWords) {
    const DicomFolder folder;
    folder.edit_all(modality_lut, "a table with its description");
    const std::string message = folder.refusal_of_folder();
    EXPECT_NE(message.find("Modality LUT Sequence"), std::string::npos) << message;
}

TEST(DicomPadding, BecomesAirAndIsCounted) {
    Volume volume(small_grid(), 40);
    volume.voxels[0] = volume.voxels[700] = -2000;
    const DicomFolder folder(volume);
    folder.edit_all(padding_value, word(-2000));
    folder.edit_all(intercept, "24");
    ReadRemarks remarks;
    const Volume read = folder.read(&remarks);
    EXPECT_EQ(read.voxels[0], -1024);
    EXPECT_EQ(read.voxels[700], -1024);
    EXPECT_EQ(read.voxels[1], 64);
    EXPECT_TRUE(mentions(remarks, "2 of 1287 voxels are padding"));
}

TEST(DicomPadding, IsSaidOfASingleVoxelAndOfNone) {
    Volume volume(small_grid(), 40);
    for (const bool padded : {false, true}) {
        if (padded) volume.voxels[700] = -2000;
        const DicomFolder folder(volume);
        folder.edit_all(padding_value, word(-2000));
        ReadRemarks remarks;
        folder.read(&remarks);
        EXPECT_EQ(mentions(remarks, "1 of 1287 voxels are padding"), padded);
        EXPECT_EQ(mentions(remarks, "padding"), padded);
    }
}

TEST(DicomPadding, MayBeARangeAndIsNoObjectOfAMask) {
    Volume volume(small_grid(), 40);
    for (std::size_t i = 0; i < 10; ++i) volume.voxels[i] = static_cast<std::int16_t>(-2000 + i);
    const DicomFolder folder(volume);
    folder.edit_all(padding_value, word(-1995));
    folder.edit_all(padding_limit, word(-2000));
    const Volume read = folder.read();
    EXPECT_EQ(std::ranges::count(read.voxels, -1024), 6);
    EXPECT_EQ(read.voxels[6], -1994);
    Job job;
    const Mask mask = read_mask(folder.path(), job);
    EXPECT_EQ(std::ranges::count(mask.voxels, 0), 6);
}

// PS3.5 A.5: everything behind the file meta group is deflated. Made by zlib from the plain file.
void deflate_slice(const std::filesystem::path& file) {
    const std::string plain = bytes_of_file(file);
    // Preamble, DICM, (0002,0000) UL 4 and the length of the group that follows.
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(plain[i]); };
    const std::size_t group = byte(140) | byte(141) << 8 | byte(142) << 16 | byte(143) << 24;
    const std::size_t data_at = 144 + group;
    // The transfer syntax 1.2.840.10008.1.2.1 has a null behind it to make its length even.
    std::string meta = plain.substr(0, data_at);
    const std::string old_uid = std::string("1.2.840.10008.1.2.1") + '\0';
    const std::string new_uid = "1.2.840.10008.1.2.1.99";
    const std::size_t at = meta.find(old_uid);
    ASSERT_NE(at, std::string::npos);
    meta.replace(at, old_uid.size(), new_uid);
    meta[at - 2] = static_cast<char>(new_uid.size());
    meta[140] = static_cast<char>(group + 2);
    meta[141] = static_cast<char>((group + 2) >> 8);
    std::string deflated(plain.size() + 1000, '\0');
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    std::string data = plain.substr(data_at);
    stream.next_in = reinterpret_cast<Bytef*>(data.data());
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(deflated.data());
    stream.avail_out = static_cast<uInt>(deflated.size());
    ASSERT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    deflated.resize(stream.total_out);
    deflateEnd(&stream);
    write_bytes(file, meta + deflated);
}

TEST(DicomDeflated, IsRead) {
    const DicomFolder folder;
    for (int i = 1; i <= 9; ++i) deflate_slice(folder.slice(i));
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    EXPECT_TRUE(remarks.empty());
}

TEST(DicomDeflated, CutShortIsNamed) {
    const DicomFolder folder;
    for (int i = 1; i <= 9; ++i) deflate_slice(folder.slice(i));
    std::string bytes = bytes_of_file(folder.slice(5));
    write_bytes(folder.slice(5), bytes.substr(0, bytes.size() - 40));
    EXPECT_NE(folder.refusal_of_folder().find("slice_0005.dcm"), std::string::npos);
}

}  // namespace
}  // namespace hepatica
