// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory the program has taken from the heap: parts of a scene are weighed by the
// difference before and after they are built.
#pragma once

#include <cstddef>

namespace hepatica {

// Bytes in use now, mapped blocks included; 0 where the C library cannot tell.
std::size_t heap_bytes_in_use();

}  // namespace hepatica
