// SPDX-License-Identifier: GPL-3.0-or-later
// A case at rest as a picture, without any display.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

class World;
struct PictureOptions;

// What a picture says of each vertex: its vessel's system and, where asked, the liver's segment.
// Throws InputError where there are no segments.
void colour_vessels(const World& world, const PatientCase& patient, bool by_segment,
                    PictureOptions& picture);

// From the front, with the gaps that are offered. Returns false, and writes nothing, in a program
// that was built without pictures. Throws InputError where the file cannot be written, Cancelled.
bool write_case_picture(const std::shared_ptr<const PatientCase>& patient,
                        const std::filesystem::path& file, Job& job);

}  // namespace hepatica
