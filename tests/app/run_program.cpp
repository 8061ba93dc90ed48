// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/run_program.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace hepatica::test {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments, const fs::path& output,
                                 const fs::path& errors, const RunLimits& limits) {
    if (!limits.interrupt_at.empty()) setpgid(0, 0);
    // Not as the test program was started: in the background of a script it would not hear Ctrl-C.
    std::signal(limits.signal, limits.ignored ? SIG_IGN : SIG_DFL);
    if (std::freopen(output.c_str(), "w", stdout) == nullptr ||
        std::freopen(errors.c_str(), "w", stderr) == nullptr)
        _exit(127);
    if (limits.file_bytes >= 0) {
        const auto bytes = static_cast<rlim_t>(limits.file_bytes);
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (limits.seconds > 0) alarm(limits.seconds);
    std::vector<char*> argv;
    std::string program = limits.program.empty() ? HEPATICA_CLI : limits.program;
    argv.push_back(program.data());
    std::vector<std::string> copies = arguments;
    for (std::string& argument : copies) argv.push_back(argument.data());
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    _exit(127);
}

}  // namespace

Outcome run_cli(const std::vector<std::string>& arguments, const RunLimits& limits) {
    const std::string unique = std::to_string(getpid());
    const fs::path output = fs::temp_directory_path() / ("hepatica-out-" + unique);
    const fs::path errors = fs::temp_directory_path() / ("hepatica-err-" + unique);
    const pid_t child = fork();
    if (child == 0) become_program(arguments, output, errors, limits);
    int status = 0;
    if (!limits.interrupt_at.empty()) {
        while ((text_of(errors) + text_of(output)).find(limits.interrupt_at) == std::string::npos &&
               waitpid(child, &status, WNOHANG) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        kill(-child, limits.signal);  // to all of its group, as a terminal does
    }
    waitpid(child, &status, 0);
    Outcome run;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    run.output = text_of(output);
    run.errors = text_of(errors);
    fs::remove(output);
    fs::remove(errors);
    return run;
}

}  // namespace hepatica::test
