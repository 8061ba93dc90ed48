// SPDX-License-Identifier: GPL-3.0-or-later
// Signals by which the system ends a program for what it writes. A closed pipe and a limit on the
// size of files have to fail like a full disk instead: a person may have unsaved work.
#pragma once

#include <csignal>

namespace hepatica {

// For the whole program; to be called before it writes.
inline void ignore_signals_of_writing() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace hepatica
