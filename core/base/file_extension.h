// SPDX-License-Identifier: GPL-3.0-or-later
// The ending by which a file's format is known.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// The extension in small letters, with its dot: ".swc" of TREE.SWC, as some systems write names.
// Empty where there is none.
std::string extension_of(const std::filesystem::path& file);

}  // namespace hepatica
