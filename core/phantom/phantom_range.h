// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of what may be asked of a phantom.
#pragma once

#include <string>

namespace hepatica {

// Throws InputError, naming the option, unless low <= value <= high.
void require_range(const std::string& name, double value, double low, double high);

}  // namespace hepatica
