// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/processor_check.h"

#include <cpuid.h>
#include <unistd.h>

#include <cstring>

namespace hepatica {
namespace {

struct Feature {
    const char* name;
    unsigned ProcessorWords::*word;
    unsigned bits;  // all must be set
};

// x86-64 psABI, table 3.1, up to level 3. XCR0 must enable the registers of SSE and of AVX.
const Feature needed[] = {
    {"SSE4.2", &ProcessorWords::leaf_1_ecx, 1U << 20U},
    {"POPCNT", &ProcessorWords::leaf_1_ecx, 1U << 23U},
    {"AVX", &ProcessorWords::leaf_1_ecx, 1U << 28U},
    {"AVX2", &ProcessorWords::leaf_7_ebx, 1U << 5U},
    {"BMI1", &ProcessorWords::leaf_7_ebx, 1U << 3U},
    {"BMI2", &ProcessorWords::leaf_7_ebx, 1U << 8U},
    {"F16C", &ProcessorWords::leaf_1_ecx, 1U << 29U},
    {"FMA", &ProcessorWords::leaf_1_ecx, 1U << 12U},
    {"LZCNT", &ProcessorWords::extended_leaf_ecx, 1U << 5U},
    {"MOVBE", &ProcessorWords::leaf_1_ecx, 1U << 22U},
    {"AVX kept by the operating system", &ProcessorWords::saved_state, 0x6U},
};

constexpr unsigned osxsave = 1U << 27U;

void append(char* text, std::size_t size, const char* more) {
    const std::size_t used = std::strlen(text);
    std::strncat(text, more, size - used - 1);
}

// Runs in .preinit_array, before the C++ library and streams are set up; it may only make system
// calls.
void check_processor(int /*argc*/, char** argv, char** /*environment*/) {
    char names[160] = "";
    if (missing_features(this_processor(), names, sizeof names) == 0) return;
    char message[512] = "";
    append(message, sizeof message, argv[0] != nullptr ? argv[0] : "hepatica");
    append(
        message, sizeof message,
        ": this program needs a processor with AVX2, as Intel makes since 2013 and AMD since 2015. "
        "This one lacks: ");
    append(message, sizeof message, names);
    append(message, sizeof message,
           ".\nBuilt with cmake -D HEPATICA_CPU=x86-64 it runs here, more slowly.\n");
    const ssize_t written = write(STDERR_FILENO, message, std::strlen(message));
    _exit(written < 0 ? 3 : 1);
}

__attribute__((section(".preinit_array"), used)) void (*check_first)(int, char**,
                                                                     char**) = check_processor;

}  // namespace

ProcessorWords this_processor() {
    ProcessorWords words;
    unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
    if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0) words.leaf_1_ecx = ecx;
    if (__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0) words.leaf_7_ebx = ebx;
    if (__get_cpuid(0x80000001U, &eax, &ebx, &ecx, &edx) != 0) words.extended_leaf_ecx = ecx;
    // The instruction that reads XCR0 exists where this bit is set.
    if ((words.leaf_1_ecx & osxsave) != 0)
        __asm__("xgetbv" : "=a"(words.saved_state), "=d"(edx) : "c"(0));
    return words;
}

int missing_features(const ProcessorWords& words, char* names, std::size_t size) {
    int missing = 0;
    names[0] = '\0';
    for (const Feature& feature : needed) {
        if ((words.*feature.word & feature.bits) == feature.bits) continue;
        if (missing++ > 0) append(names, size, ", ");
        append(names, size, feature.name);
    }
    return missing;
}

}  // namespace hepatica
