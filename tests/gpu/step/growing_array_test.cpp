// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays on a machine: they lie where their values may lie and are zero at first. One that is set
// again and again holds what was set last, and what did not change was not copied.
#include "gpu/step/growing_array.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "gpu/kernels/element_kernels.h"
#include "gpu/machine/array.h"
#include "gpu/machine/emulator.h"

namespace hepatica {
namespace {

using gpu::GrowingArray;

std::vector<int> held_by(gpu::Machine& machine, const GrowingArray<int>& array) {
    std::vector<int> held(array.size());
    if (!held.empty()) machine.download(held.data(), array.read().data, held.size() * sizeof(int));
    return held;
}

TEST(GrowingArray, HoldsWhatWasSetLast) {
    const auto machine = gpu::make_emulator();
    GrowingArray<int> array(*machine);
    std::vector<int> values;
    unsigned random = 7;
    const auto next = [&](unsigned below) {
        random = random * 1664525u + 1013904223u;
        return (random >> 8) % below;
    };
    for (int round = 0; round < 200; ++round) {
        values.resize(next(60000));
        for (int k = 0; k < 5 && !values.empty(); ++k)
            values[next(static_cast<unsigned>(values.size()))] = round + 1;
        if (!values.empty() && round % 3 == 0) values.back() = -round;
        array.set(values);
        ASSERT_EQ(held_by(*machine, array), values) << round;
    }
}

TEST(GrowingArray, CopiesThePartsThatChanged) {
    const auto machine = gpu::make_emulator();
    std::vector<int> values(100000);
    std::iota(values.begin(), values.end(), 0);
    GrowingArray<int> array(*machine);
    const auto copied_by = [&](const std::vector<int>& set) {
        const gpu::Traffic before = machine->traffic();
        array.set(set);
        return std::array{machine->traffic().copies - before.copies,
                          static_cast<long>(machine->traffic().copied_bytes - before.copied_bytes)};
    };
    EXPECT_EQ(copied_by(values), (std::array{1L, 400000L}));
    EXPECT_EQ(copied_by(values), (std::array{0L, 0L}));
    values[10] = values[50000] = values[99999] = -1;
    const auto [copies, bytes] = copied_by(values);
    EXPECT_EQ(copies, 3);
    EXPECT_LT(bytes, 3 * 16384 + 1);
    // In the memory that it has: what is new alone, and the end of what was there.
    values.resize(99000);
    copied_by(values);
    values.resize(100000, 5);
    EXPECT_LT(copied_by(values)[1], 2 * 16384 + 1);
}

// What kernels keep may want more than malloc gives: 32 bytes for three numbers in double.
TEST(Array, LiesWhereItsValuesMayLie) {
    const auto machine = gpu::make_emulator();
    for (const std::size_t size : {1u, 3u, 100u, 10000u, 100000u}) {
        using Padded = gpu::Aligned3<double>;
        const gpu::Array<Padded> first(*machine, size), second(*machine, size);
        for (const gpu::Array<Padded>* array : {&first, &second})
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array->read().data) % alignof(Padded), 0u)
                << size;
    }
}

// Arrays are zero at first, also in memory that held something before.
TEST(Array, IsZeroAtFirst) {
    const auto machine = gpu::make_emulator();
    for (int round = 0; round < 3; ++round) {
        gpu::Array<int> array(*machine, 1000);
        std::vector<int> held(array.size(), -1);
        array.download(held);
        EXPECT_EQ(held, std::vector<int>(1000, 0));
        array.upload(std::vector<int>(1000, 7));
    }
}

}  // namespace
}  // namespace hepatica
