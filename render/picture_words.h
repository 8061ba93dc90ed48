// SPDX-License-Identifier: GPL-3.0-or-later
// The words that are drawn into pictures: legend, scale bar, forces, gaps. They are English unless
// whoever draws says how they are said in another language.
#pragma once

#include <functional>
#include <string>

namespace hepatica {

// Of an English text with its numbers, such as "12.5 mN" or "Drug arrival (s)"; empty: as it is.
using PictureWords = std::function<std::string(const std::string& english)>;

inline std::string said(const PictureWords& words, const std::string& english) {
    return words ? words(english) : english;
}

}  // namespace hepatica
