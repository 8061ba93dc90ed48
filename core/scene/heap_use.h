// SPDX-License-Identifier: GPL-3.0-or-later
// How much heap memory the program uses: the cost of a scene's parts is the difference before and
// after they are built.
#pragma once

#include <cstddef>

namespace hepatica {

// Bytes in use now, including mapped blocks; 0 where the C library cannot tell.
std::size_t heap_bytes_in_use();

}  // namespace hepatica
