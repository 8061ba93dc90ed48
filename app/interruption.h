// SPDX-License-Identifier: GPL-3.0-or-later
// Hears Ctrl-C (SIGINT), the wish that the program should end (SIGTERM), and that its terminal was
// closed (SIGHUP), so that a job can be cancelled and leaves nothing half done. A second Ctrl-C
// ends the program at once: some work does not look whether it is cancelled. Files appear whole or
// not at all even then; temporary ones may stay, with what lay beside the files of a case that was
// just being replaced.
#pragma once

#include <array>

namespace hepatica {

inline constexpr int exit_interrupted = 130;

// Owns the handlers of the three signals while it lives; only one may exist at a time. A signal
// that was ignored before stays ignored: shells start jobs in the background without SIGINT, nohup
// without SIGHUP.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // Whether one of them has come since the last one of these began. Thread-safe.
    static bool came();

  private:
    std::array<void (*)(int), 3> handlers_before_{};
};

}  // namespace hepatica
