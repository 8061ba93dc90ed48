// SPDX-License-Identifier: GPL-3.0-or-later
// Words are absorbed one by one; the last, incomplete word and the length follow at the end.
#include "core/base/hash.h"

#include <bit>
#include <cstring>

#include "core/base/file_blocks.h"

namespace hepatica {

namespace {

constexpr std::uint64_t fnv_prime = 0x100000001b3ULL;

std::uint64_t absorb(std::uint64_t state, std::uint64_t word) {
    state = (state ^ word) * fnv_prime;
    return state ^ (state >> 29);  // mixes the high half into the low one, which plain FNV does not
}

}  // namespace

void Hasher::add_bytes(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    length_ += size;
    std::size_t i = 0;
    // Whole words at once if none is incomplete: for speed, as a state is hashed after every
    // recorded step.
    for (; pending_bytes_ == 0 && i + 8 <= size && std::endian::native == std::endian::little;
         i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + i, sizeof word);
        state_ = absorb(state_, word);
    }
    for (; i < size; ++i) {
        pending_ |= static_cast<std::uint64_t>(bytes[i]) << (8 * pending_bytes_);
        if (++pending_bytes_ == 8) {
            state_ = absorb(state_, pending_);
            pending_ = 0;
            pending_bytes_ = 0;
        }
    }
}

std::uint64_t Hasher::value() const {
    std::uint64_t h = absorb(absorb(state_, pending_), length_);
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdULL;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return h ^ (h >> 33);
}

std::string to_hex(std::uint64_t value) {
    std::string text(16, '0');
    for (int i = 15; i >= 0; --i, value >>= 4) text[i] = "0123456789abcdef"[value & 15];
    return text;
}

std::uint64_t hash_of_file(const std::filesystem::path& file) {
    Hasher hasher;
    for_each_block(file, [&](std::span<const std::byte> block) { hasher.add(block); });
    return hasher.value();
}

}  // namespace hepatica
