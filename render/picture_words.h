// SPDX-License-Identifier: GPL-3.0-or-later
// The words that are drawn into pictures: legend, scale bar, forces. They are English unless the
// program says how they are said in another language.
#pragma once

#include <functional>
#include <string>

namespace hepatica {

// Of an English text with its numbers, such as "12.5 mN" or "Drug arrival (s)".
using PictureWords = std::function<std::string(const std::string& english)>;

// For all pictures that are drawn from now on, by the thread that draws them.
void set_picture_words(PictureWords words);
std::string in_picture(const std::string& english);

}  // namespace hepatica
