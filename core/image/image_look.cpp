// SPDX-License-Identifier: GPL-3.0-or-later
// Reads only the header.
#include "core/image/image_look.h"

#include "core/image/dicom_header.h"
#include "core/image/header_text.h"
#include "core/image/voxel_file.h"

namespace hepatica {

void look_at_image(const std::filesystem::path& file) {
    if (lower_case(file.filename().string()) == "dicomdir" || is_dicom_file(file)) return;
    read_header(file);
}

}  // namespace hepatica
