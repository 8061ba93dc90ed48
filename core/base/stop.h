// SPDX-License-Identifier: GPL-3.0-or-later
// Cancellation inside a time step: the caller passes a std::stop_token, which is checked between
// iterations. A token without a source never requests a stop.
#pragma once

#include <stop_token>

#include "core/base/error.h"

namespace hepatica {

// Throws Cancelled if a stop has been requested. Costs one read of memory, so it is suitable for
// any loop whose body takes more than some hundred operations. Thread-safe.
inline void throw_if_stopped(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Cancelled();
}

}  // namespace hepatica
