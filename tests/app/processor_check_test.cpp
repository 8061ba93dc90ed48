// SPDX-License-Identifier: GPL-3.0-or-later
// A processor that lacks what the program needs is told so in words, by code that runs on any
// processor.
#include "app/processor_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/shell.h"

namespace hepatica {
namespace {

struct Answer {
    int count = 0;
    std::string names;
};

Answer missing_in(const ProcessorWords& words) {
    char names[256];
    const int count = missing_features(words, names, sizeof names);
    return {count, names};
}

// As their makers' processors answer: Haswell of 2013, the first with all; Nehalem of 2008.
constexpr ProcessorWords haswell{0x7ffafbff, 0x000027ab, 0x00000021, 0x7};
constexpr ProcessorWords nehalem{0x009ce3bd, 0, 0x00000001, 0};

TEST(ProcessorCheck, PassesTheProcessorThatRunsThisTest) {
    EXPECT_EQ(missing_in(this_processor()).names, "");
    EXPECT_EQ(missing_in(haswell).count, 0);
}

TEST(ProcessorCheck, NamesWhatAnOlderProcessorLacks) {
    const Answer answer = missing_in(nehalem);
    EXPECT_EQ(answer.names,
              "AVX, AVX2, BMI1, BMI2, F16C, FMA, LZCNT, MOVBE, AVX kept by the operating system");
    EXPECT_EQ(answer.count, 9);
}

// The numbers of the bits are those of Intel's manual, volume 2, CPUID.
TEST(ProcessorCheck, LooksAtEachBit) {
    const struct {
        unsigned ProcessorWords::*word;
        int bit;
        const char* name;
    } cases[] = {{&ProcessorWords::leaf_1_ecx, 12, "FMA"},
                 {&ProcessorWords::leaf_1_ecx, 20, "SSE4.2"},
                 {&ProcessorWords::leaf_1_ecx, 22, "MOVBE"},
                 {&ProcessorWords::leaf_1_ecx, 23, "POPCNT"},
                 {&ProcessorWords::leaf_1_ecx, 28, "AVX"},
                 {&ProcessorWords::leaf_1_ecx, 29, "F16C"},
                 {&ProcessorWords::leaf_7_ebx, 3, "BMI1"},
                 {&ProcessorWords::leaf_7_ebx, 5, "AVX2"},
                 {&ProcessorWords::leaf_7_ebx, 8, "BMI2"},
                 {&ProcessorWords::extended_leaf_ecx, 5, "LZCNT"},
                 {&ProcessorWords::saved_state, 1, "AVX kept by the operating system"},
                 {&ProcessorWords::saved_state, 2, "AVX kept by the operating system"}};
    for (const auto& one : cases) {
        ProcessorWords words = haswell;
        words.*one.word &= ~(1U << static_cast<unsigned>(one.bit));
        EXPECT_EQ(missing_in(words).names, one.name);
    }
}

TEST(ProcessorCheck, NeverWritesBeyondTheTextItIsGiven) {
    char names[12] = "..........";
    names[11] = '!';
    EXPECT_EQ(missing_features(nehalem, names, 11), 9);
    EXPECT_STREQ(names, "AVX, AVX2,");
    EXPECT_EQ(names[11], '!');
}

// Weak functions may be replaced by another file's copies of them, and those use AVX2.
TEST(ProcessorCheck, ItsOwnCodeRunsOnEveryProcessor) {
    const std::string object = "'" HEPATICA_PROCESSOR_OBJECT "'";
    const test::ShellAnswer symbols = test::shell("nm -C " + object);
    ASSERT_EQ(symbols.exit_code, 0) << symbols.output;
    EXPECT_THAT(symbols.output, testing::HasSubstr(" T hepatica::this_processor()"));
    for (const char* kind : {" W ", " V ", " u "})
        EXPECT_THAT(symbols.output, testing::Not(testing::HasSubstr(kind)));
    const test::ShellAnswer code = test::shell("objdump -d --no-show-raw-insn " + object);
    ASSERT_EQ(code.exit_code, 0);
    EXPECT_THAT(code.output, testing::HasSubstr("cpuid"));
    for (const char* newer : {"ymm", "\tvmov", "\tvpxor", "\tandn", "\tshlx", "\tmovbe"})
        EXPECT_THAT(code.output, testing::Not(testing::HasSubstr(newer)));
}

// The whole programs on the emulated processor of 2008: their libraries are loaded, and then they
// speak.
TEST(ProcessorCheck, TheProgramsSayItOnAnOldProcessor) {
    if (test::shell("command -v qemu-x86_64").exit_code != 0)
        GTEST_SKIP() << "qemu-x86_64 (package qemu-user) is not installed";
    for (const std::string program : {HEPATICA_PROGRAMS}) {
        const test::ShellAnswer answer =
            test::shell("qemu-x86_64 -cpu Nehalem '" + program + "' --help");
        EXPECT_EQ(answer.exit_code, 1) << answer.output;
        EXPECT_THAT(answer.output, testing::HasSubstr("This one lacks: AVX, AVX2"));
    }
}

}  // namespace
}  // namespace hepatica
