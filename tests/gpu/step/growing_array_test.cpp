// SPDX-License-Identifier: GPL-3.0-or-later
// An array on a machine that is set again and again: it holds what was set last, and what did not
// change was not copied.
#include "gpu/step/growing_array.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

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

}  // namespace
}  // namespace hepatica
