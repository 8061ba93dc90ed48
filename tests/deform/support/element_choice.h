// SPDX-License-Identifier: GPL-3.0-or-later
// Which element a test of several of them is about.
#pragma once

#include <ostream>

#include "core/deform/body/body.h"

namespace hepatica::test {

struct ElementChoice {
    const char* name;
    ElementModel model;
    ElementOrder order;
    bool hexahedra;
};

inline std::ostream& operator<<(std::ostream& out, const ElementChoice& choice) {
    return out << choice.name;
}

}  // namespace hepatica::test
