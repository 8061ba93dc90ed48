// SPDX-License-Identifier: GPL-3.0-or-later
// Every reader of files that come from outside, each fed from memory: for libFuzzer, which invents
// the bytes, and for the tests, which feed the inputs kept in corpus/NAME.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace hepatica::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct Reader {
    std::string_view name;  // of its folder in corpus/
    // Reads what the bytes hold or refuses them by InputError. Anything else that is thrown, and
    // what was read but does not keep the reader's promises, is a fault and passes through.
    void (*read)(Bytes);
};

std::span<const Reader> image_readers();
std::span<const Reader> tree_readers();  // trees and meshes
std::span<const Reader> json_readers();

}  // namespace hepatica::fuzz
