// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever fills a new block of memory waits once for each page of it. An image of a hundred
// megabytes has 25,000 small pages but 50 large ones, and a reconstruction fills dozens of images.
#pragma once

#include <cstddef>

namespace hepatica {

// Asks the system to lay memory that has not been touched yet on large pages, where it knows them
// and the block is so large that they fit. Changes no contents; where it is refused, nothing is.
void prefer_large_pages(void* begin, std::size_t bytes);

}  // namespace hepatica
