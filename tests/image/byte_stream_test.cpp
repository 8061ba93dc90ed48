// SPDX-License-Identifier: GPL-3.0-or-later
// What zlib deflated comes back whole, however the reads are divided.
#include "core/image/byte_stream.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <string>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// Window bits as zlib has them: -15 for bare deflate data, 15 for zlib, 31 for gzip.
std::string deflated(const std::string& plain, int window_bits) {
    std::string bytes(plain.size() + 1000, '\0');
    std::string data = plain;
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(data.data());
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    bytes.resize(stream.total_out);
    deflateEnd(&stream);
    return bytes;
}

class ByteStreams : public testing::Test {
  protected:
    void SetUp() override {
        file_ = fs::path(testing::TempDir()) /
                (std::string("hepatica-") +
                 testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override { fs::remove(file_); }

    std::string read_in_pieces(const std::string& bytes, Encoding encoding, std::size_t piece) {
        std::ofstream(file_, std::ios::binary) << bytes;
        ByteStream stream(file_, 0, encoding);
        std::string all;
        std::string part(piece, '\0');
        while (const std::size_t got = stream.read_some(part.data(), piece))
            all.append(part, 0, got);
        return all;
    }

    fs::path file_;
};

// A run of one letter ends in a match of up to 258 bytes. At many of these lengths (21 and 375 are
// the first) the end of the block lies in the match's last byte, so that the input is used up while
// most of the match is still to be delivered.
TEST_F(ByteStreams, DeliverWhatZlibHoldsAtTheEndOfTheFile) {
    for (std::size_t length = 1; length <= 600; ++length) {
        const std::string plain(length, 'a');
        EXPECT_EQ(read_in_pieces(deflated(plain, -15), Encoding::bare_deflated, 7), plain)
            << length;
    }
}

TEST_F(ByteStreams, GiveTheSameForEveryEncodingAndPiece) {
    std::string plain;
    for (int i = 0; i < 3000; ++i) plain += std::to_string(i * i % 977);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{100'000}}) {
        EXPECT_EQ(read_in_pieces(plain, Encoding::raw, piece), plain);
        EXPECT_EQ(read_in_pieces(deflated(plain, -15), Encoding::bare_deflated, piece), plain);
        EXPECT_EQ(read_in_pieces(deflated(plain, 15), Encoding::deflated, piece), plain);
        EXPECT_EQ(read_in_pieces(deflated(plain, 31), Encoding::deflated, piece), plain);
        const std::string two_members = deflated(plain, 31) + deflated("second", 31) + "padding";
        EXPECT_EQ(read_in_pieces(two_members, Encoding::deflated, piece), plain + "second");
    }
}

TEST_F(ByteStreams, EndWhereCompressedDataAreCutShort) {
    const std::string plain(5000, 'a');
    const std::string bytes = deflated(plain, -15);
    const std::string begin =
        read_in_pieces(bytes.substr(0, bytes.size() - 3), Encoding::bare_deflated, 7);
    EXPECT_LT(begin.size(), plain.size());
    EXPECT_TRUE(plain.starts_with(begin));
    EXPECT_EQ(read_in_pieces("", Encoding::bare_deflated, 7), "");
    ByteStream stream(file_, 0, Encoding::bare_deflated);
    char byte = 0;
    EXPECT_THROW(stream.read(&byte, 1), InputError);
}

}  // namespace
}  // namespace hepatica
