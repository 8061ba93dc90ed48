// SPDX-License-Identifier: GPL-3.0-or-later
// Translation of the words that are drawn into pictures: legend, scale bar, forces, gaps. Without
// it they are English.
#pragma once

#include <functional>
#include <string>

namespace hepatica {

// Translates an English text with its numbers, such as "12.5 mN" or "Drug arrival (s)"; an empty
// function leaves it as it is.
using PictureWords = std::function<std::string(const std::string& english)>;

inline std::string said(const PictureWords& words, const std::string& english) {
    return words ? words(english) : english;
}

}  // namespace hepatica
