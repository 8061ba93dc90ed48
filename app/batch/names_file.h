// SPDX-License-Identifier: GPL-3.0-or-later
// Which pseudonym of a batch is which scan: the one file of its folder that is not to be shared.
#pragma once

#include <filesystem>
#include <vector>

#include "app/batch/batch_inputs.h"

namespace hepatica {

// Adds them to OUT/names.csv, which only its owner may read; who stands there already stays, also
// where the folder of scans has changed since. Every task of a batch writes the same. Throws
// InputError where it cannot be read or written, or calls two scans by one name.
void write_names(const std::filesystem::path& out, const std::vector<BatchInput>& inputs);

}  // namespace hepatica
