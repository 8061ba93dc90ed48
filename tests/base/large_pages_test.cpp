// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/large_vector.h"

namespace hepatica {
namespace {

// The flags that the system keeps for the memory around an address, as it prints them.
std::string flags_at(const void* address) {
    const auto wanted = reinterpret_cast<std::uintptr_t>(address);
    std::ifstream maps("/proc/self/smaps");
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0, end = 0;
        char dash = 0;
        std::istringstream words(line);
        if (words >> std::hex >> begin >> dash >> end && dash == '-')
            here = begin <= wanted && wanted < end;
        if (here && line.starts_with("VmFlags:")) return line + " ";
    }
    return "";
}

bool advised(const std::vector<std::uint8_t>& block) {
    return flags_at(block.data() + block.size() / 2).find(" hg ") != std::string::npos;
}

TEST(LargePages, AreAskedForWhereABlockIsLarge) {
    if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage"))
        GTEST_SKIP() << "this system has no large pages";
    std::vector<std::uint8_t> large, plain;
    large.reserve(std::size_t{96} << 20);
    prefer_large_pages(large.data(), large.capacity());
    large.resize(large.capacity(), 7);
    EXPECT_TRUE(advised(large)) << flags_at(large.data());
    plain.resize(std::size_t{96} << 20);
    EXPECT_FALSE(advised(plain)) << flags_at(plain.data());
}

TEST(LargePages, AreAskedForByVectorsThatReserveThem) {
    if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage"))
        GTEST_SKIP() << "this system has no large pages";
    std::vector<std::uint8_t> values{1, 2, 3};
    reserve_large(values, std::size_t{96} << 20);
    const std::uint8_t* const begin = values.data();
    values.resize(std::size_t{96} << 20, 7);
    EXPECT_EQ(values.data(), begin);  // the room was there
    EXPECT_TRUE(advised(values)) << flags_at(values.data());
    EXPECT_EQ(values[0] + values[1] + values[2], 6);
    reserve_large(values, 5);
    EXPECT_EQ(values.size(), std::size_t{96} << 20);
}

TEST(LargePages, LeaveContentsAsTheyAre) {
    std::vector<std::uint8_t> block(std::size_t{9} << 20);
    for (std::size_t i = 0; i < block.size(); ++i) block[i] = static_cast<std::uint8_t>(i % 251);
    for (const std::size_t begin : {0, 1, 4095, 4096, 70001})
        prefer_large_pages(block.data() + begin, block.size() - begin);
    prefer_large_pages(nullptr, 0);
    for (std::size_t i = 0; i < block.size(); ++i) ASSERT_EQ(block[i], i % 251);
}

}  // namespace
}  // namespace hepatica
