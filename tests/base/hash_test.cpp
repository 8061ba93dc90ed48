// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/hash.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace hepatica {
namespace {

std::uint64_t hash_of(const std::string& text) {
    Hasher hasher;
    hasher.add_bytes(text.data(), text.size());
    return hasher.value();
}

TEST(Hash, DoesNotDependOnHowTheStreamIsCut) {
    std::mt19937 random(7);
    std::string text(1000, ' ');
    for (char& c : text) c = static_cast<char>(random());
    for (int trial = 0; trial < 100; ++trial) {
        Hasher hasher;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t piece = std::min<std::size_t>(random() % 23, text.size() - at);
            hasher.add_bytes(text.data() + at, piece);
            at += piece;
        }
        EXPECT_EQ(hasher.value(), hash_of(text));
    }
}

TEST(Hash, TellsEverySingleBitFlipAndTrailingZeroApart) {
    const std::string text(64, 'a');
    std::set<std::uint64_t> seen{hash_of(text), hash_of(text + '\0')};
    for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
        std::string flipped = text;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        seen.insert(hash_of(flipped));
    }
    EXPECT_EQ(seen.size(), text.size() * 8 + 2);
}

// Files and recordings of earlier versions keep such values: computed apart, from FNV-1a over words
// and MurmurHash3's finaliser, in arithmetic of any length.
TEST(Hash, IsWhatFilesKeep) {
    EXPECT_EQ(hash_of(""), 0xbac1775082379709ULL);
    EXPECT_EQ(hash_of("hepatica"), 0x53b35475967cf2acULL);
    EXPECT_EQ(hash_of("a vessel of the liver"), 0x4cd7e4607ec42d7eULL);
}

TEST(Hash, OfAFileIsThatOfItsBytes) {
    const auto file = std::filesystem::path(testing::TempDir()) / "hash.bin";
    for (const std::size_t size : {0u, 1u, 65'536u, 200'000u}) {
        std::string text(size, ' ');
        for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i % 251);
        std::ofstream(file, std::ios::binary) << text;
        EXPECT_EQ(hash_of_file(file), hash_of(text)) << size;
    }
    std::filesystem::remove(file);
    EXPECT_THROW(hash_of_file(file), InputError);
}

// Linux lets /proc/self/mem be opened and fails to read its first page, which is not mapped.
TEST(Hash, OfWhatCannotBeReadIsNone) {
    EXPECT_THROW(hash_of_file(testing::TempDir()), InputError);
    EXPECT_THROW(hash_of_file("/proc/self/mem"), InputError);
}

TEST(Hash, HexHasSixteenDigits) {
    EXPECT_EQ(to_hex(0), "0000000000000000");
    EXPECT_EQ(to_hex(0x0123456789abcdefULL), "0123456789abcdef");
}

}  // namespace
}  // namespace hepatica
