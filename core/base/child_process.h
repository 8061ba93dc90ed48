// SPDX-License-Identifier: GPL-3.0-or-later
// A program run as a child process under limits of memory and time: for files that may come from
// anybody and are read by a library that may crash, hang or take all memory. None of that reaches
// the program that waits for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

struct ChildLimits {
    std::uint64_t memory_bytes = 0;  // of address space (RLIMIT_AS)
    int seconds = 0;                 // by the clock, and of processor time (RLIMIT_CPU)
};

struct ChildOutcome {
    enum class End { exited, killed, out_of_time };
    End end = End::exited;
    int number = 0;      // the exit code, or the signal that killed it
    std::string errors;  // what it wrote to standard error, the first 4096 bytes of it
};

// Runs the program and waits. It has no input, its output is dropped, no file of ours is open in
// it, and it ends with the thread that waits for it. Throws Cancelled, once the child is killed and
// gone, within about 20 ms of the job's cancellation; InputError where no process can be made. A
// program that cannot be executed exits with 127.
ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, const ChildLimits& limits,
                       const Job& job);

}  // namespace hepatica
