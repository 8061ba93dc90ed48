// SPDX-License-Identifier: GPL-3.0-or-later
// fork and exec with resource limits; standard error is read through a pipe.
#include "core/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

#include "core/base/error.h"

// The sanitizers reserve terabytes of address space, so RLIMIT_AS cannot be used with them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HEPATICA_HAS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HEPATICA_HAS_SANITIZER
#endif
#endif

namespace hepatica {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_error_bytes = 4096;
constexpr int poll_ms = 20;
constexpr int exit_not_started = 127;

void limit(__rlimit_resource what, std::uint64_t most, std::uint64_t at_last) {
    const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(at_last)};
    if (setrlimit(what, &both) != 0) _exit(exit_not_started);
}

// In the child, between fork and exec. Only async-signal-safe calls are allowed, because other
// threads may have held any lock at the fork.
[[noreturn]] void become(char* const* arguments, const ChildLimits& limits, int error_pipe,
                         pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(exit_not_started);  // the parent ended before prctl
    setpgid(0, 0);  // keeps Ctrl+C from the child: the parent kills it
    const int nothing = open("/dev/null", O_RDWR);
    if (nothing < 0 || dup2(error_pipe, STDERR_FILENO) < 0 || dup2(nothing, STDIN_FILENO) < 0 ||
        dup2(nothing, STDOUT_FILENO) < 0 || close_range(3, ~0U, 0) != 0)
        _exit(exit_not_started);
#ifndef HEPATICA_HAS_SANITIZER
    limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
#endif
    // SIGXCPU first, which tells the reason, and a second later SIGKILL, which cannot be ignored.
    const auto seconds = static_cast<std::uint64_t>(limits.seconds);
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    execv(arguments[0], arguments);
    _exit(exit_not_started);
}

// The child, seen from the parent. The destructor kills it and waits for it if it still runs.
class Child {
  public:
    Child(std::vector<std::string> command, const ChildLimits& limits) {
        std::vector<char*> arguments;
        for (std::string& part : command) arguments.push_back(part.data());
        arguments.push_back(nullptr);
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse(command.front());
        error_pipe_ = ends[0];
        fcntl(error_pipe_, F_SETFL, O_NONBLOCK);  // only this end: the child may block
        const pid_t parent = getpid();
        id_ = fork();
        if (id_ == 0) become(arguments.data(), limits, ends[1], parent);
        close(ends[1]);
        if (id_ < 0) {
            close(error_pipe_);
            refuse(command.front());
        }
    }
    ~Child() {
        if (!ended_) {
            kill(id_, SIGKILL);
            wait_for(0);
        }
        close(error_pipe_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Waits for at most poll_ms; true once the child has ended.
    bool has_ended() {
        pollfd end{error_pipe_, POLLIN, 0};
        poll(&end, 1, poll_ms);
        const bool closed = !take_errors();
        // A child that has closed standard error is about to end, or runs on; waiting avoids a busy
        // loop.
        if (closed && !wait_for(WNOHANG)) poll(nullptr, 0, poll_ms);
        return wait_for(WNOHANG);
    }

    void kill_now() {
        kill(id_, SIGKILL);
        wait_for(0);
    }

    ChildOutcome outcome() {
        take_errors();
        ChildOutcome outcome;
        outcome.errors = errors_;
        if (WIFEXITED(status_)) {
            outcome.number = WEXITSTATUS(status_);
        } else {
            outcome.end = WTERMSIG(status_) == SIGXCPU ? ChildOutcome::End::out_of_time
                                                       : ChildOutcome::End::killed;
            outcome.number = WTERMSIG(status_);
        }
        return outcome;
    }

  private:
    [[noreturn]] static void refuse(const std::string& program) {
        throw InputError("cannot be started (" + std::generic_category().message(errno) + ")",
                         program, "End other programs, and try again");
    }

    // Reads what is available; false once the other end is closed.
    bool take_errors() {
        std::array<char, 1024> part{};
        for (;;) {
            const ssize_t got = read(error_pipe_, part.data(), part.size());
            if (got < 0) return errno == EAGAIN || errno == EINTR;
            if (got == 0) return false;
            const std::size_t room = most_error_bytes - errors_.size();
            errors_.append(part.data(), std::min(static_cast<std::size_t>(got), room));
        }
    }

    bool wait_for(int options) {
        while (!ended_) {
            const pid_t answer = waitpid(id_, &status_, options);
            if (answer == 0) return false;
            if (answer < 0 && errno == EINTR) continue;
            ended_ = true;
        }
        return true;
    }

    pid_t id_ = -1;
    int error_pipe_ = -1;
    int status_ = 0;
    bool ended_ = false;
    std::string errors_;
};

}  // namespace

ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, const ChildLimits& limits,
                       const Job& job) {
    job.throw_if_cancelled();
    std::vector<std::string> command{program.string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Clock::time_point latest = Clock::now() + std::chrono::seconds(limits.seconds);
    Child child(std::move(command), limits);
    while (!child.has_ended()) {
        job.throw_if_cancelled();
        if (Clock::now() < latest) continue;
        child.kill_now();
        ChildOutcome outcome = child.outcome();
        outcome.end = ChildOutcome::End::out_of_time;
        return outcome;
    }
    return child.outcome();
}

}  // namespace hepatica
