// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the ranges of a phantom's options.
#pragma once

#include <string>

namespace hepatica {

// Throws InputError, naming the option, unless low <= value <= high.
void require_range(const std::string& name, double value, double low, double high);

}  // namespace hepatica
