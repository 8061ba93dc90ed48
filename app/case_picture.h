// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a case at rest, without a display.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

class World;
struct PictureOptions;

// Sets the picture's data for each vertex: its vessel's system and, on request, its liver segment.
// Throws InputError where there are no segments.
void colour_vessels(const World& world, const PatientCase& patient, bool by_segment,
                    PictureOptions& picture);

// Draws the case from the front, with the gaps that are offered. Returns false, and writes nothing,
// in a build without pictures. Throws InputError where the file cannot be written; Cancelled.
bool write_case_picture(const std::shared_ptr<const PatientCase>& patient,
                        const std::filesystem::path& file, Job& job);

}  // namespace hepatica
