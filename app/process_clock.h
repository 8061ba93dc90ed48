// SPDX-License-Identifier: GPL-3.0-or-later
// How long this process has been alive, loading of libraries included.
#pragma once

namespace hepatica {

// Seconds since the kernel started the process, to a hundredth; negative where /proc cannot tell.
double seconds_since_process_start();

}  // namespace hepatica
