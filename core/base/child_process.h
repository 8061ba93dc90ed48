// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program as a child process with limits of memory and time: for files from unknown sources
// that a library reads which may crash, hang or exhaust the memory. The calling program is not
// affected.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

struct ChildLimits {
    std::uint64_t memory_bytes = 0;  // of address space (RLIMIT_AS)
    int seconds = 0;                 // of wall time, and of processor time (RLIMIT_CPU)
};

struct ChildOutcome {
    enum class End { exited, killed, out_of_time };
    End end = End::exited;
    int number = 0;      // the exit code, or the signal that killed it
    std::string errors;  // the first 4096 bytes of its standard error
};

// Runs the program and waits for its end. Its input is empty, its output is dropped, no open file
// is inherited, and it is killed when the waiting thread ends. Throws Cancelled within about 20 ms
// of the job's cancellation, after the child has been killed; InputError if no process can be
// created. A program that cannot be executed gives exit code 127. Thread-safe.
ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, const ChildLimits& limits,
                       const Job& job);

}  // namespace hepatica
