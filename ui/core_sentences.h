// SPDX-License-Identifier: GPL-3.0-or-later
// What core and the devices' back end say to a user of the window, sentence by sentence: its
// English is the id by which it is translated. %1, %2 stand for what core puts in.
// tests/ui/core_words_test.cpp reads the sources and fails on a sentence that is missing here.
#pragma once

#include <span>
#include <vector>

namespace hepatica {

// Of all rooms. The first one is translated into every language; see translated().
const std::vector<const char*>& core_sentences();

// By what they are about, each in a file of its own.
std::span<const char* const> sentences_of_common();
std::span<const char* const> sentences_of_image();
std::span<const char* const> sentences_of_patient();
std::span<const char* const> sentences_of_tree();
std::span<const char* const> sentences_of_play();
std::span<const char* const> sentences_of_lesson();
std::span<const char* const> sentences_of_built_in_lessons();
std::span<const char* const> sentences_of_back_ends();

}  // namespace hepatica
