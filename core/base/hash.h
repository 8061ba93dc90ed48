// SPDX-License-Identifier: GPL-3.0-or-later
// A 64-bit hash (FNV-1a over 8-byte words, with a final mixer) for case files and simulation
// states. It detects accidental changes and divergence; it does not protect against forgery.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>

namespace hepatica {

// Hashes a stream of bytes fed in pieces; the result does not depend on how it is divided. Not
// thread-safe.
class Hasher {
  public:
    void add_bytes(const void* data, std::size_t size);

    template <class T>
    void add(std::span<const T> values) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
        add_bytes(values.data(), values.size_bytes());
    }

    std::uint64_t value() const;

  private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
    std::uint64_t pending_ = 0;
    int pending_bytes_ = 0;
    std::uint64_t length_ = 0;
};

// 16 lower-case hexadecimal digits.
std::string to_hex(std::uint64_t value);

// Hash of a file's bytes. Throws InputError if it is a folder or cannot be read to its end.
std::uint64_t hash_of_file(const std::filesystem::path& file);

}  // namespace hepatica
