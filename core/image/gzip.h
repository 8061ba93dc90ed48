// SPDX-License-Identifier: GPL-3.0-or-later
// Compression to one gzip stream (RFC 1952) on all cores: blocks are deflated separately and joined
// at byte boundaries, so the bytes do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <ostream>
#include <span>
#include <vector>

namespace hepatica {

// Writes the pieces in order as one gzip member. Errors show in the state of the stream.
void write_gzip(std::ostream& out, const std::vector<std::span<const std::byte>>& pieces);

}  // namespace hepatica
