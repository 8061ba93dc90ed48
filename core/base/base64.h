// SPDX-License-Identifier: GPL-3.0-or-later
// Base64 with padding (RFC 4648): four characters for three bytes. Thread-safe.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hepatica {

std::string to_base64(std::string_view bytes);

// The bytes; none if the text is not a result of to_base64().
std::optional<std::string> from_base64(std::string_view text);

}  // namespace hepatica
