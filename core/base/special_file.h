// SPDX-License-Identifier: GPL-3.0-or-later
// Devices, pipes and sockets as places to write to: they are written into, because a rename, which
// lets a file appear as a whole, would put a file in their place.
#pragma once

#include <filesystem>
#include <system_error>

namespace hepatica {

// Whether it is, or a link leads to, a device, a pipe or a socket.
bool is_special_file(const std::filesystem::path& file);

// Writes all bytes of `from` into it, and waits for a slow reader until a signal comes
// (std::errc::interrupted). A pipe that nobody has opened to read and a disk as a whole are
// refused.
std::error_code write_into_special_file(const std::filesystem::path& from,
                                        const std::filesystem::path& to);

}  // namespace hepatica
