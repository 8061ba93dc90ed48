// SPDX-License-Identifier: GPL-3.0-or-later
// A CT series from a DICOM folder, decoded by GDCM (JPEG, JPEG-LS, JPEG 2000, RLE included).
#pragma once

#include <filesystem>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/image/volume_reader.h"

namespace hepatica {

// The largest CT series of the folder, or, where `member` names one of its files, that file's
// series. For the rest see read_volume.
Volume read_dicom(const std::filesystem::path& folder, const std::filesystem::path& member,
                  Job& job, ReadRemarks& remarks);

}  // namespace hepatica
