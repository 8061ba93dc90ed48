// SPDX-License-Identifier: GPL-3.0-or-later
// Checks an allocation whose size comes from a file's header.
#pragma once

#include <cstdint>
#include <string>

namespace hepatica {

// Product of the three sizes and the bytes per value; the largest number if it overflows.
std::uint64_t bytes_of(std::int64_t nx, std::int64_t ny, std::int64_t nz, std::int64_t value_bytes);

// "3.2 GB", "377 bytes".
std::string readable_bytes(std::uint64_t bytes);

// Throws InputError, naming `place`, if `bytes` exceeds 80 % of the memory that the system reports
// as available, or of the memory that the process may still map under its own limit (ulimit -v).
void require_memory(std::uint64_t bytes, const std::string& place);

}  // namespace hepatica
