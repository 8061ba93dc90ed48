// SPDX-License-Identifier: GPL-3.0-or-later
// The language of a test's window.
#pragma once

#include "ui/language.h"

namespace hepatica::testing {

// For as long as it lives; before the window of a test is made, and after it is gone.
class Speaks {
  public:
    explicit Speaks(const QString& language) { use_language(language); }
    ~Speaks() { use_language("en"); }
    Speaks(const Speaks&) = delete;
    Speaks& operator=(const Speaks&) = delete;
};

}  // namespace hepatica::testing
