// SPDX-License-Identifier: GPL-3.0-or-later
// Which pseudonym of a batch is which scan: the one file of its folder that is not to be shared.
#pragma once

#include <filesystem>
#include <vector>

#include "app/batch/batch_inputs.h"

namespace hepatica {

// OUT/names.csv, readable by its owner alone; every task of a batch writes the same. Throws
// InputError.
void write_names(const std::filesystem::path& out, const std::vector<BatchInput>& inputs);

}  // namespace hepatica
