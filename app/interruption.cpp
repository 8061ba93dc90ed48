// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hepatica {

namespace {

// When the first of the signals came; 0: none has. The only variable that the handler touches.
std::atomic<std::int64_t> asked_ms = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

// `timeout` sends its signal to the program and again to its process group: that is one wish.
constexpr std::int64_t one_wish_ms = 200;

// Only async-signal-safe calls are allowed here.
void on_interrupt(int number) {
    using std::chrono::milliseconds;
    const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
    const std::int64_t now_ms = std::chrono::duration_cast<milliseconds>(since_boot).count();
    std::int64_t before_ms = 0;
    if (asked_ms.compare_exchange_strong(before_ms, now_ms)) return;
    if (number != SIGINT || now_ms - before_ms < one_wish_ms) return;
    constexpr std::string_view words = "\nended at once by a second Ctrl-C\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words.data(), words.size());
    ::_exit(exit_interrupted);
}

constexpr std::array handled{SIGINT, SIGTERM, SIGHUP};

}  // namespace

Interruption::Interruption() {
    asked_ms = 0;
    for (std::size_t i = 0; i < handled.size(); ++i) {
        handlers_before_[i] = std::signal(handled[i], on_interrupt);
        if (handlers_before_[i] == SIG_IGN) std::signal(handled[i], SIG_IGN);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < handled.size(); ++i) std::signal(handled[i], handlers_before_[i]);
}

bool Interruption::came() {
    return asked_ms != 0;
}

}  // namespace hepatica
