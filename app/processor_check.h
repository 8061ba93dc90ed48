// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that a processor lacks instructions this program was compiled for (x86-64-v3: AVX2 and
// its companions), before the first of them would kill it without a message.
//
// The .cpp is compiled for every x86-64 processor, calls no inline function of a library (the
// linker might take a copy from another file, with AVX2 in it), and is in the executable's
// .preinit_array, which runs before all other code of the program and its libraries.
#pragma once

#include <cstddef>

namespace hepatica {

// CPUID and XCR0 words that describe a processor's features; bits as in its manuals.
struct ProcessorWords {
    unsigned leaf_1_ecx = 0;         // CPUID 1
    unsigned leaf_7_ebx = 0;         // CPUID 7, subleaf 0
    unsigned extended_leaf_ecx = 0;  // CPUID 80000001h
    unsigned saved_state = 0;        // which registers the operating system saves
};

ProcessorWords this_processor();

// Writes the names of the features of x86-64-v3 that the processor lacks, "AVX2, FMA", into
// `names`, truncated to `size` bytes > 0 and always terminated by zero. Returns how many are
// missing.
int missing_features(const ProcessorWords& words, char* names, std::size_t size);

}  // namespace hepatica
