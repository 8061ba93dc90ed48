// SPDX-License-Identifier: GPL-3.0-or-later
// Guards an allocation whose size comes from a file's header.
#pragma once

#include <cstdint>
#include <string>

namespace hepatica {

// Product of the three sizes and the bytes of a value; the largest number where it overflows.
std::uint64_t bytes_of(std::int64_t nx, std::int64_t ny, std::int64_t nz, std::int64_t value_bytes);

// "3.2 GB", "377 bytes".
std::string readable_bytes(std::uint64_t bytes);

// Throws InputError, naming `place`, where `bytes` is more than 80 % of the memory that the system
// says is available now, or of what the process may still map under its own limit (ulimit -v).
void require_memory(std::uint64_t bytes, const std::string& place);

}  // namespace hepatica
