// SPDX-License-Identifier: GPL-3.0-or-later
// The table that resolves a batch's pseudonyms to scans, the one file of its folder that must not
// be shared.
#pragma once

#include <filesystem>
#include <vector>

#include "app/batch/batch_inputs.h"

namespace hepatica {

// Adds the inputs to OUT/names.csv, which only its owner may read; existing entries are kept, even
// if the folder of scans has changed. Every task of a batch writes the same content. Throws
// InputError where the file cannot be read or written, or would give two scans one name.
void write_names(const std::filesystem::path& out, const std::vector<BatchInput>& inputs);

}  // namespace hepatica
