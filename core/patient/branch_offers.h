// SPDX-License-Identifier: GPL-3.0-or-later
// Branches that are offered with a case: which of them lead out of its tree.
#pragma once

#include <vector>

#include "core/patient/patient_case.h"

namespace hepatica {

// Whether a branch begins in or at a vessel of the tree, runs mostly outside of all vessels, and
// ends away from them, so that drawing it adds a branch and closes no loop.
bool leads_out_of(const VesselTree& tree, const Bridge& branch);

// Offers of these branches those that lead out of the patient's tree, or out of another of them,
// which are then offered once that one is taken.
void offer_branches(const std::vector<Bridge>& branches, PatientCase& patient);

}  // namespace hepatica
