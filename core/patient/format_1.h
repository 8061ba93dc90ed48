// SPDX-License-Identifier: GPL-3.0-or-later
// Reads cases of format 1, which kept paths instead of a digest of the CT, and numbers of systems
// without names: 0 where no seeds were set, else the numbers of the seeds (1 portal vein, 2 hepatic
// veins, 3 artery). Edits that gave a branch of an unseeded case to a system used the numbering of
// the window instead: 0 portal vein, 1 hepatic veins, 2 artery.
#pragma once

#include <string>

#include "core/patient/patient_case.h"

namespace hepatica {

// The parameters without the paths of masks, which may hold a patient's name. Throws
// nlohmann::json::exception where they are malformed.
std::string parameters_of_format_1(const std::string& parameters_json);

// The edits of corrections.json with named systems; `seeded` selects the numbering. 0 and unknown
// numbers become the unknown system. Throws nlohmann::json::exception where they are malformed.
std::string edits_of_format_1(const std::string& edits_json, bool seeded);

// Whether the extracted tree has known systems.
bool is_seeded_format_1(const VesselTree& extracted);

// Corrects the systems of an unseeded case's edited tree, which was read by the numbering of seeds.
void rename_systems_of_format_1(VesselTree& tree);

// Turns the labels of a mask into numbers of systems. Several labels are numbers of seeds. A single
// label becomes the tree's system where it has only one, else unknown.
void relabel_format_1(Mask& mask, const VesselTree& extracted);

}  // namespace hepatica
