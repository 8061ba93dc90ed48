// SPDX-License-Identifier: GPL-3.0-or-later
// Says in words that a processor lacks instructions this program was compiled with (x86-64-v3: AVX2
// and its companions), where the first of them would end it without a word.
//
// The .cpp is compiled for every x86-64 processor, calls no inline function of a library (the
// linker might take another file's copy of it, with AVX2 inside), and stands in the executable's
// .preinit_array, which runs before any other code of it and of its libraries.
#pragma once

#include <cstddef>

namespace hepatica {

// The words in which a processor says what it can do, as its manuals number their bits.
struct ProcessorWords {
    unsigned leaf_1_ecx = 0;         // CPUID 1
    unsigned leaf_7_ebx = 0;         // CPUID 7, subleaf 0
    unsigned extended_leaf_ecx = 0;  // CPUID 80000001h
    unsigned saved_state = 0;        // XCR0: which registers the operating system keeps
};

ProcessorWords this_processor();

// Writes the names of what x86-64-v3 has and such a processor lacks, "AVX2, FMA", into `names`, cut
// where `size` bytes are too few, always with a zero at its end. Returns how many are missing.
int missing_features(const ProcessorWords& words, char* names, std::size_t size);

}  // namespace hepatica
