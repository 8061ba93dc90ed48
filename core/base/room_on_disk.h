// SPDX-License-Identifier: GPL-3.0-or-later
// Tells before some work whether what it writes on the way can be written.
#pragma once

#include <cstddef>
#include <filesystem>

namespace hepatica {

// Throws InputError that names the folder and says why, such as a full disk, where no new file of
// so many bytes can be written into it. Writes one and removes it; a folder that is missing is
// made.
void require_room(const std::filesystem::path& folder, std::size_t bytes);

}  // namespace hepatica
