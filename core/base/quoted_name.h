// SPDX-License-Identifier: GPL-3.0-or-later
// Names that people gave (files, folders, what was typed at a scanner) inside of sentences: on the
// screen they help to find what is meant, but they often name a patient. They stand between “ and
// ”, so that they can be left out of whatever is written and passed on.
#pragma once

#include <string>
#include <string_view>

namespace hepatica {

// “name”; the two quotation marks themselves are taken out of the name, and bytes that are no UTF-8
// become U+FFFD.
std::string quoted_name(std::string_view name);

// The sentence with “…” in the place of every name.
std::string without_names(std::string_view sentence);

// True where every byte belongs to a character in UTF-8 (RFC 3629).
bool is_utf8(std::string_view text);

// The same text with U+FFFD for each byte that does not.
std::string as_utf8(std::string_view text);

}  // namespace hepatica
