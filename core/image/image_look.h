// SPDX-License-Identifier: GPL-3.0-or-later
// A first check of an image file by its header alone.
#pragma once

#include <filesystem>

namespace hepatica {

// Throws InputError, as read_volume() does, if the header of the file shows that it is not a
// readable image. DICOM files are accepted unchecked: their series is in the folder.
void look_at_image(const std::filesystem::path& file);

}  // namespace hepatica
