// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include <csignal>
#include <cstddef>

namespace hepatica {

namespace {

// The only variable that the signal handler touches.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
    interrupted = 1;
}

constexpr std::array handled{SIGINT, SIGTERM, SIGHUP};

}  // namespace

Interruption::Interruption() {
    interrupted = 0;
    for (std::size_t i = 0; i < handled.size(); ++i) {
        handlers_before_[i] = std::signal(handled[i], on_interrupt);
        if (handlers_before_[i] == SIG_IGN) std::signal(handled[i], SIG_IGN);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < handled.size(); ++i) std::signal(handled[i], handlers_before_[i]);
}

bool Interruption::came() {
    return interrupted != 0;
}

}  // namespace hepatica
