// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/hidden_text.h"

#include <zlib.h>

#include <array>
#include <vector>

namespace hepatica::test {

namespace {

constexpr int zlib_or_gzip = 15 + 32;  // window bits that let inflate find out which it is

// What a stream that begins here unpacks to; empty where none does.
std::string inflated(const std::string& bytes, std::size_t begin) {
    z_stream stream{};
    if (inflateInit2(&stream, zlib_or_gzip) != Z_OK) return {};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())) + begin;
    stream.avail_in = static_cast<uInt>(bytes.size() - begin);
    std::string text;
    std::vector<char> block(1 << 16);
    int state = Z_OK;
    while (state == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        state = inflate(&stream, Z_NO_FLUSH);
        text.append(block.data(), block.size() - stream.avail_out);
        if (stream.avail_in == 0 && stream.avail_out != 0) break;
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END ? text : std::string();
}

bool may_begin_stream(const std::string& bytes, std::size_t i) {
    if (i + 2 > bytes.size()) return false;
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return (first == 0x1f && second == 0x8b) || (first == 0x78 && (first * 256 + second) % 31 == 0);
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    return c == '/' ? 63 : -1;
}

std::string decoded(const std::string& digits) {
    std::string text;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 4) {
        unsigned group = 0;
        const std::size_t count = std::min<std::size_t>(4, digits.size() - i);
        for (std::size_t k = 0; k < 4; ++k)
            group =
                group << 6 | (k < count ? static_cast<unsigned>(base64_digit(digits[i + k])) : 0);
        for (std::size_t k = 0; k + 1 < count; ++k)
            text += static_cast<char>(group >> (16 - 8 * k) & 255);
    }
    return text;
}

}  // namespace

std::string unpacked(const std::string& bytes, int depth) {
    std::string all = bytes;
    if (depth == 0) return all;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        if (may_begin_stream(bytes, i)) all += unpacked(inflated(bytes, i), depth - 1);
    constexpr std::size_t least_digits = 24;
    for (std::size_t begin = 0; begin < bytes.size();) {
        std::size_t end = begin;
        while (end < bytes.size() && base64_digit(bytes[end]) >= 0) ++end;
        if (end - begin >= least_digits)
            all += unpacked(decoded(bytes.substr(begin, end - begin)), depth - 1);
        begin = end + 1;
    }
    return all;
}

}  // namespace hepatica::test
