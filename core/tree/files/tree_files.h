// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of tree files have in common.
#pragma once

#include <filesystem>
#include <string>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// A file's bytes. Throws InputError that names it where it cannot be read.
std::string read_text(const std::filesystem::path& file);

// validate() with the file named as the place.
void validate_from_file(const VesselTree& tree, const std::filesystem::path& file);

}  // namespace hepatica
