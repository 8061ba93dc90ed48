// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 (FIPS 180-4): the digest of a file, which any machine can check with `sha256sum`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace hepatica {

// Digests a stream of bytes fed in pieces; the result does not depend on how it is divided. Not
// thread-safe.
class Sha256 {
  public:
    void add_bytes(const void* data, std::size_t size);

    // 64 lower-case hexadecimal digits. Nothing may be added afterwards.
    std::string hex_digest();

  private:
    void compress();

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> block_{};
    std::size_t filled_ = 0;    // bytes in the block
    std::uint64_t length_ = 0;  // bytes in total
};

// Digest of a file's bytes, as `sha256sum FILE` prints it. Throws InputError if it is a folder or
// cannot be read to its end.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace hepatica
