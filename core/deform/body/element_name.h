// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the tetrahedral elements in files and commands.
#pragma once

#include <string>
#include <utility>

#include "core/deform/body/body.h"

namespace hepatica {

// "spring", "corotated" or "neohookean", followed by "-10" for quadratic order.
std::string element_name(ElementModel model, ElementOrder order);

// Throws UsageError for any other name. There is no "spring-10".
std::pair<ElementModel, ElementOrder> element_of(const std::string& name);

}  // namespace hepatica
