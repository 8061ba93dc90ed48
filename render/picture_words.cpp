// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_words.h"

#include <utility>

namespace hepatica {
namespace {

PictureWords& words_in_use() {
    static PictureWords words;
    return words;
}

}  // namespace

void set_picture_words(PictureWords words) {
    words_in_use() = std::move(words);
}

std::string in_picture(const std::string& english) {
    return words_in_use() ? words_in_use()(english) : english;
}

}  // namespace hepatica
