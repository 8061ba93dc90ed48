// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of tetrahedra by the names that files and commands use.
#pragma once

#include <string>
#include <utility>

#include "core/deform/body/body.h"

namespace hepatica {

// "spring", "corotated", "neohookean"; with "-10" behind it for quadratic order.
std::string element_name(ElementModel model, ElementOrder order);

// Throws UsageError for a name that is none of these. There is no "spring-10".
std::pair<ElementModel, ElementOrder> element_of(const std::string& name);

}  // namespace hepatica
