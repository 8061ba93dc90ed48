// SPDX-License-Identifier: GPL-3.0-or-later
// What every entry point does with what a reader throws, and with what it promises.
#pragma once

#include <stdexcept>

#include "core/base/error.h"

namespace hepatica::fuzz {

inline void promise(bool kept, const char* what) {
    if (!kept) throw std::logic_error(what);
}

template <class Read>
void refuse_or(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
        // Refused in words, as it should be.
    }
}

}  // namespace hepatica::fuzz
