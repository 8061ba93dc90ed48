// SPDX-License-Identifier: GPL-3.0-or-later
// Stores a motion of the centreline in a file of raw numbers, so that a slow reference need not be
// computed again on the same machine.
#pragma once

#include <filesystem>
#include <optional>

#include "core/study/pull_trial.h"

namespace hepatica {

// Writes atomically. Throws InputError where it cannot be written.
void write_motion(const std::filesystem::path& file, const CentrelineMotion& motion);

// Empty where the file is missing or does not hold exactly `vectors` finite vectors.
std::optional<CentrelineMotion> read_motion(const std::filesystem::path& file, std::size_t vectors);

}  // namespace hepatica
