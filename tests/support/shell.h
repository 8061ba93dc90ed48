// SPDX-License-Identifier: GPL-3.0-or-later
// What a command line of the shell prints, and how it ends.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace hepatica::test {

struct ShellAnswer {
    int exit_code = -1;  // minus the signal's number where one ended it
    std::string output;  // standard output and errors together
};

inline ShellAnswer shell(const std::string& command) {
    ShellAnswer answer;
    FILE* const pipe = popen(("(" + command + ") 2>&1").c_str(), "r");
    if (pipe == nullptr) return answer;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        answer.output += static_cast<char>(c);
    const int status = pclose(pipe);
    answer.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return answer;
}

}  // namespace hepatica::test
