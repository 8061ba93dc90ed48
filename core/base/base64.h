// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as text of RFC 4648 (base64 with padding): four characters for three bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hepatica {

std::string to_base64(std::string_view bytes);

// None where the text is not what to_base64 writes.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace hepatica
