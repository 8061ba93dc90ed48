// SPDX-License-Identifier: GPL-3.0-or-later
// The facilities of this computer: processor, graphics processor, library versions.
#pragma once

#include <nlohmann/json.hpp>

namespace hepatica {

// Contains `cuda{compiled, architectures, device, memory_bytes, driver, reason}`; missing values
// are null.
nlohmann::ordered_json diagnosis();

}  // namespace hepatica
