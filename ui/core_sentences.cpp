// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/core_sentences.h"

namespace hepatica {
namespace {

std::vector<const char*> joined() {
    std::vector<const char*> all;
    for (const auto& sentences :
         {sentences_of_common(), sentences_of_image(), sentences_of_patient(), sentences_of_tree(),
          sentences_of_play(), sentences_of_lesson(), sentences_of_built_in_lessons(),
          sentences_of_back_ends()})
        all.insert(all.end(), sentences.begin(), sentences.end());
    return all;
}

}  // namespace

const std::vector<const char*>& core_sentences() {
    static const std::vector<const char*> all = joined();
    return all;
}

}  // namespace hepatica
