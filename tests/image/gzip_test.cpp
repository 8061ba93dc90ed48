// SPDX-License-Identifier: GPL-3.0-or-later
// Streams as zlib reads them: what it finds in them and what they say of themselves.
#include "core/image/gzip.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>

namespace hepatica {
namespace {

std::string compressed(const std::vector<std::string>& pieces) {
    std::vector<std::span<const std::byte>> spans;
    for (const std::string& piece : pieces) spans.push_back(std::as_bytes(std::span(piece)));
    std::ostringstream out;
    write_gzip(out, spans);
    return out.str();
}

// One member to its end, whose checksum and size zlib compares; what stands in its header.
std::string inflated(const std::string& bytes, std::size_t size, gz_header& header) {
    std::string plain(size + 1, '\0');
    std::string in = bytes;
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
    EXPECT_EQ(inflateGetHeader(&stream, &header), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(plain.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(stream.avail_in, 0u);
    plain.resize(stream.total_out);
    inflateEnd(&stream);
    return plain;
}

// No time, no name, no text and no system: nothing but the data decides about the bytes.
TEST(Gzip, IsOneMemberThatSaysNothingOfItsOrigin) {
    std::mt19937 random(8);
    std::string noise(2'700'000, '\0');  // three blocks
    std::ranges::generate(noise, [&] { return static_cast<char>(random() % 16); });
    for (const auto& pieces :
         {std::vector<std::string>{}, {""}, {"a"}, {"first", "", "second"}, {"head", noise}}) {
        std::string whole;
        for (const std::string& piece : pieces) whole += piece;
        gz_header header{};
        EXPECT_EQ(inflated(compressed(pieces), whole.size(), header), whole);
        EXPECT_EQ(header.done, 1);
        EXPECT_EQ(header.time, 0u);
        EXPECT_EQ(header.xflags, 0);
        EXPECT_EQ(header.text, 0);
        EXPECT_EQ(header.hcrc, 0);
        EXPECT_EQ(header.os, 255);  // unknown, in RFC 1952
    }
}

}  // namespace
}  // namespace hepatica
