// SPDX-License-Identifier: GPL-3.0-or-later
// Against the examples of NIST (FIPS 180-2 appendix B and the SHA-2 additional test vectors).
#include "core/base/sha256.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace hepatica {
namespace {

std::string digest_of(const std::string& text) {
    Sha256 digest;
    digest.add_bytes(text.data(), text.size());
    return digest.hex_digest();
}

TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(digest_of("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                        "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu"),
              "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
    EXPECT_EQ(digest_of(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Lengths at which the padding just fits, just does not, and makes a block of its own.
TEST(Sha256, PadsEveryLength) {
    EXPECT_EQ(digest_of(std::string(55, '\0')),
              "02779466cdec163811d078815c633f21901413081449002f24aa3e80f0b88ef7");
    EXPECT_EQ(digest_of(std::string(56, '\0')),
              "d4817aa5497628e7c77e6b606107042bbba3130888c5f47a375e6179be789fbb");
    EXPECT_EQ(digest_of(std::string(57, '\0')),
              "65a16cb7861335d5ace3c60718b5052e44660726da4cd13bb745381b235a1785");
    EXPECT_EQ(digest_of(std::string(64, '\0')),
              "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b");
}

TEST(Sha256, DoesNotDependOnWhereThePiecesEnd) {
    std::string text;
    for (int i = 0; i < 300; ++i) text += static_cast<char>(i * 7);
    for (const std::size_t piece : {1u, 3u, 63u, 64u, 65u, 299u}) {
        Sha256 digest;
        for (std::size_t i = 0; i < text.size(); i += piece)
            digest.add_bytes(text.data() + i, std::min(piece, text.size() - i));
        EXPECT_EQ(digest.hex_digest(), digest_of(text)) << piece;
    }
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
    const auto file = std::filesystem::path(testing::TempDir()) / "sha256.bin";
    const std::string text(200'001, 'x');
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_EQ(sha256_of_file(file), digest_of(text));
    std::filesystem::remove(file);
    EXPECT_THROW(sha256_of_file(file), InputError);
}

// Linux lets /proc/self/mem be opened and fails to read its first page, which is not mapped.
TEST(Sha256, OfWhatCannotBeReadIsNone) {
    EXPECT_THROW(sha256_of_file(testing::TempDir()), InputError);
    EXPECT_THROW(sha256_of_file("/proc/self/mem"), InputError);
}

}  // namespace
}  // namespace hepatica
