// SPDX-License-Identifier: GPL-3.0-or-later
// English sentences of core and of the device back end that a user may see; each is the id of its
// translation, with %1, %2 for inserted text. tests/ui/core_words_test.cpp fails if a sentence of
// the sources is missing here.
#pragma once

#include <span>
#include <vector>

namespace hepatica {

// All sentences. The first one must be translated into every language; see translated().
const std::vector<const char*>& core_sentences();

// By topic, each in a file of its own.
std::span<const char* const> sentences_of_common();
std::span<const char* const> sentences_of_image();
std::span<const char* const> sentences_of_patient();
std::span<const char* const> sentences_of_tree();
std::span<const char* const> sentences_of_play();
std::span<const char* const> sentences_of_lesson();
std::span<const char* const> sentences_of_built_in_lessons();
std::span<const char* const> sentences_of_back_ends();

}  // namespace hepatica
