// SPDX-License-Identifier: GPL-3.0-or-later
// The age of this process, loading of libraries included.
#pragma once

namespace hepatica {

// Seconds since the kernel started the process, to a hundredth; negative where /proc does not tell.
double seconds_since_process_start();

}  // namespace hepatica
