// SPDX-License-Identifier: GPL-3.0-or-later
// Private sequences of an unknown value representation (UN): archives write them so where they make
// explicit representations of implicit ones and do not know the maker's tags. What is within them
// stays implicit (PS3.5 6.2.2).
#include <gtest/gtest.h>

#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

using namespace testing_support;

std::string number_of_bytes(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xff);
    return text;
}

std::string tag_of(std::uint32_t group, std::uint32_t element) {
    return number_of_bytes(group, 2) + number_of_bytes(element, 2);
}

// A sequence with one item, both of undefined length.
std::string sequence_of(const std::string& tag, const std::string& representation,
                        const std::string& content) {
    const std::string undefined = number_of_bytes(0xffffffff, 4), none = number_of_bytes(0, 4);
    return tag + representation + number_of_bytes(0, 2) + undefined + tag_of(0xfffe, 0xe000) +
           undefined + content + tag_of(0xfffe, 0xe00d) + none + tag_of(0xfffe, 0xe0dd) + none;
}

std::string unknown_sequence() {
    const std::string value = "a private value ";
    return sequence_of(tag_of(0x0029, 0x1010), "UN",
                       tag_of(0x0029, 0x1020) +
                           number_of_bytes(static_cast<std::uint32_t>(value.size()), 4) + value);
}

// Puts elements in front of the number of rows.
void insert_into(const std::filesystem::path& file, const std::string& elements) {
    std::string bytes = bytes_of_file(file);
    const std::size_t rows = bytes.find(tag_of(0x0028, 0x0010) + "US");
    ASSERT_NE(rows, std::string::npos);
    write_bytes(file, bytes.insert(rows, elements));
}

void expect_read_with(const std::string& elements) {
    const DicomFolder folder;
    for (int i = 1; i <= 9; ++i) insert_into(folder.slice(i), elements);
    ASSERT_EQ(folder.refusal_of_folder(), "");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    EXPECT_TRUE(remarks.empty());
}

TEST(DicomPrivateSequence, OfUnknownRepresentationIsPassedOver) {
    expect_read_with(unknown_sequence());
}

// The whole slice counted as damaged.
TEST(DicomPrivateSequence, OfUnknownRepresentationWithinAStandardSequenceIsPassedOver) {
    const std::string standard = tag_of(0x0040, 0x0275);
    expect_read_with(sequence_of(standard, "SQ", unknown_sequence()));
    expect_read_with(sequence_of(standard, "SQ", sequence_of(standard, "SQ", unknown_sequence())));
}

}  // namespace
}  // namespace hepatica
