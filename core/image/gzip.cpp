// SPDX-License-Identifier: GPL-3.0-or-later
// zlib with a sync flush after each block of 1 MiB; the checksums are combined.
#include "core/image/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/parallel.h"

namespace hepatica {

namespace {

constexpr std::size_t block_bytes = 1 << 20;
constexpr std::size_t batch_blocks = 64;  // compressed at a time, to limit the memory
constexpr int level = 4;  // higher levels take far longer for hardly smaller CT images

struct Block {
    std::span<const std::byte> plain;
    std::vector<unsigned char> deflated;
    uLong checksum = 0;
};

// Compresses a block to raw deflate data that end at a byte boundary without ending the stream.
void deflate_block(Block& block) {
    z_stream stream{};
    deflateInit2(&stream, level, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    const auto size = static_cast<uInt>(block.plain.size());
    block.deflated.resize(deflateBound(&stream, size) + 16);
    auto* plain = reinterpret_cast<const Bytef*>(block.plain.data());
    stream.next_in = const_cast<Bytef*>(plain);
    stream.avail_in = size;
    stream.next_out = block.deflated.data();
    stream.avail_out = static_cast<uInt>(block.deflated.size());
    deflate(&stream, Z_SYNC_FLUSH);
    block.deflated.resize(block.deflated.size() - stream.avail_out);
    deflateEnd(&stream);
    block.checksum = crc32(crc32(0, nullptr, 0), plain, size);
}

void put_bytes(std::ostream& out, const unsigned char* bytes, std::size_t count) {
    out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

void put_word(std::ostream& out, std::uint64_t word) {
    std::array<unsigned char, 4> bytes;
    for (int i = 0; i < 4; ++i) bytes[i] = static_cast<unsigned char>(word >> (8 * i));
    put_bytes(out, bytes.data(), bytes.size());
}

}  // namespace

void write_gzip(std::ostream& out, const std::vector<std::span<const std::byte>>& pieces) {
    std::vector<Block> blocks;
    std::uint64_t total = 0;
    for (const std::span<const std::byte> piece : pieces) {
        for (std::size_t at = 0; at < piece.size(); at += block_bytes)
            blocks.push_back({piece.subspan(at, std::min(block_bytes, piece.size() - at)), {}, 0});
        total += piece.size();
    }
    constexpr std::array<unsigned char, 10> header{0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 255};
    put_bytes(out, header.data(), header.size());
    uLong checksum = crc32(0, nullptr, 0);
    for (std::size_t first = 0; first < blocks.size(); first += batch_blocks) {
        const std::size_t count = std::min(batch_blocks, blocks.size() - first);
        parallel_blocks(count, 1,
                        [&](std::size_t i, std::size_t) { deflate_block(blocks[first + i]); });
        for (std::size_t i = first; i < first + count; ++i) {
            Block& block = blocks[i];
            put_bytes(out, block.deflated.data(), block.deflated.size());
            checksum =
                crc32_combine(checksum, block.checksum, static_cast<z_off_t>(block.plain.size()));
            block.deflated = {};
        }
    }
    constexpr std::array<unsigned char, 2> end_of_stream{3, 0};  // an empty final block
    put_bytes(out, end_of_stream.data(), end_of_stream.size());
    put_word(out, checksum);
    put_word(out, total);
}

}  // namespace hepatica
