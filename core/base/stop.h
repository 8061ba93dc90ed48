// SPDX-License-Identifier: GPL-3.0-or-later
// How long work inside a step hears that it is to end: whoever begins it hands in a
// std::stop_token, and it looks there between its iterations. A token without a source never asks
// to stop.
#pragma once

#include <stop_token>

#include "core/base/error.h"

namespace hepatica {

// Throws Cancelled where a stop has been asked for. Costs a read of memory, so that it may stand in
// any loop whose body takes more than some hundred operations. Any thread.
inline void throw_if_stopped(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Cancelled();
}

}  // namespace hepatica
