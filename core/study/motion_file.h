// SPDX-License-Identifier: GPL-3.0-or-later
// A motion of the centreline in a file of raw numbers, so that a reference that took minutes need
// not be computed again on the same machine.
#pragma once

#include <filesystem>
#include <optional>

#include "core/study/pull_trial.h"

namespace hepatica {

// Throws InputError where it cannot be written.
void write_motion(const std::filesystem::path& file, const CentrelineMotion& motion);

// Empty where there is no such file or it does not hold exactly `vectors` finite vectors.
std::optional<CentrelineMotion> read_motion(const std::filesystem::path& file, std::size_t vectors);

}  // namespace hepatica
