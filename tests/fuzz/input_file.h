// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as a file, for readers that want a name. One folder per process, removed at its end; set
// TMPDIR to a folder in memory where speed matters.
#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/readers.h"

namespace hepatica::fuzz {

// Replaces the file of that name, which may be in a folder ("case.hep/case.json").
std::filesystem::path file_of(Bytes bytes, const std::string& name);

}  // namespace hepatica::fuzz
