// SPDX-License-Identifier: GPL-3.0-or-later
// Names given by people (files, folders, texts typed at a scanner) inside sentences. On the screen
// they help the user, but they often name a patient. They are enclosed in “ and ”, so that they can
// be removed from anything that is stored or passed on. Thread-safe.
#pragma once

#include <string>
#include <string_view>

namespace hepatica {

// “name”; these quotation marks are removed from the name, and bytes that are not valid UTF-8
// become U+FFFD.
std::string quoted_name(std::string_view name);

// The sentence with every name replaced by “…”.
std::string without_names(std::string_view sentence);

// True if the text is valid UTF-8 (RFC 3629).
bool is_utf8(std::string_view text);

// The text with U+FFFD for each invalid byte.
std::string as_utf8(std::string_view text);

}  // namespace hepatica
