// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of format 1, which knew paths instead of a digest of the CT, and numbers of systems without
// names: 0 where nobody had set seeds, else the numbers of the seeds (1 portal vein, 2 hepatic
// veins, 3 artery). A person who gave a branch to a system of an unseeded case did so by another
// numbering, that of the window: 0 portal vein, 1 hepatic veins, 2 artery.
#pragma once

#include <string>

#include "core/patient/patient_case.h"

namespace hepatica {

// The parameters without the paths of the masks, which may hold a patient's name.
std::string parameters_of_format_1(const std::string& parameters_json);

// The edits of corrections.json with the systems named: `seeded` says which numbering holds. A
// number of neither, and 0, become the unknown system.
std::string edits_of_format_1(const std::string& edits_json, bool seeded);

// Whether the tree as it was extracted knew systems.
bool is_seeded_format_1(const VesselTree& extracted);

// Gives the edited tree of an unseeded case, read by the seeds' numbers, the systems that were
// meant.
void rename_systems_of_format_1(VesselTree& tree);

// Makes numbers of systems out of the labels of a mask. Several labels are numbers of seeds. A
// single one was everything that was found: the tree's system where it has only one, else unknown.
void relabel_format_1(Mask& mask, const VesselTree& extracted);

}  // namespace hepatica
