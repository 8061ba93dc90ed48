// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/core_sentences.h"

#include "ui/words.h"

namespace hepatica {

const std::vector<const char*>& core_sentences() {
    static const std::vector<const char*> all{
        Words::id("portal vein"),
        Words::id("hepatic veins"),
        Words::id("artery"),
        Words::id("unknown system"),
    };
    return all;
}

}  // namespace hepatica
