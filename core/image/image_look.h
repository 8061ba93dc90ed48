// SPDX-License-Identifier: GPL-3.0-or-later
// A look at an image before anything depends on it: what its header alone tells.
#pragma once

#include <filesystem>

namespace hepatica {

// Throws InputError, as read_volume() does, where the header of a file says that it is no image
// that can be read. Of a DICOM file it looks at nothing else: its series is in its folder.
void look_at_image(const std::filesystem::path& file);

}  // namespace hepatica
