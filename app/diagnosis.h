// SPDX-License-Identifier: GPL-3.0-or-later
// What this computer offers the program: processor, graphics processor, library versions.
#pragma once

#include <nlohmann/json.hpp>

namespace hepatica {

// With `cuda{compiled, architectures, device, memory_bytes, driver, reason}`; what is not there is
// null.
nlohmann::ordered_json diagnosis();

}  // namespace hepatica
