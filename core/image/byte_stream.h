// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a file from an offset on, inflated while reading where they are compressed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

namespace hepatica {

enum class Encoding {
    raw,
    deflated,      // gzip (also of several members) or zlib
    bare_deflated  // deflate data (RFC 1951) without header and checksum
};

// Not thread-safe. All members that read throw InputError that names the file, where it cannot be
// opened or read, or its compressed data are damaged.
class ByteStream {
  public:
    ByteStream(const std::filesystem::path& file, std::uint64_t offset, Encoding encoding);
    ~ByteStream();
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;

    // Fills the buffer. Throws InputError also where the data end before it is full.
    void read(void* buffer, std::size_t bytes);
    void skip(std::uint64_t bytes);
    // Reads up to `bytes` bytes, fewer at the end; returns how many.
    std::size_t read_some(void* buffer, std::size_t bytes);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace hepatica
