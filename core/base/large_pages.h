// SPDX-License-Identifier: GPL-3.0-or-later
// Large memory pages. Filling new memory costs one page fault per page: an image of a hundred
// megabytes has 25,000 small pages but 50 large ones, and a reconstruction fills dozens of images.
#pragma once

#include <cstddef>

namespace hepatica {

// Asks the system to use large pages for memory that has not been touched yet. No effect for blocks
// below 4 MiB and where the system does not support it. The content does not change. Thread-safe.
void prefer_large_pages(void* begin, std::size_t bytes);

}  // namespace hepatica
