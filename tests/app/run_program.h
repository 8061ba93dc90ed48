// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real hepatica-cli and catches what it prints.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace hepatica::test {

struct Outcome {
    int exit_code = -1;  // minus the signal's number where one ended it
    std::string output;
    std::string errors;
};

struct RunLimits {
    long file_bytes = -1;        // writes beyond it fail, as on a full disk
    std::string interrupt_at{};  // interrupted as soon as this is printed
    int signal = SIGINT;         // by this signal: Ctrl-C, unless another one is named
    bool ignored = false;        // which was ignored when the program began
    std::string program{};       // another one than hepatica-cli
    unsigned seconds = 0;        // ended by SIGALRM after so many, where it might wait for ever
};

Outcome run_cli(const std::vector<std::string>& arguments, const RunLimits& limits = {});

}  // namespace hepatica::test
