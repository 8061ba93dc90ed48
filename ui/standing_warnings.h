// SPDX-License-Identifier: GPL-3.0-or-later
// What a patient was opened or rebuilt with a warning of, as far as it still holds after his
// vessels were corrected. No toolkit.
#pragma once

#include <string>
#include <vector>

#include "core/patient/patient_case.h"

namespace hepatica {

// All that is said of his vessels as they are: ends that take most of the flow, doubtful links by
// hand, roots, doubts, a body that meets itself; in the words of the window. Empty without a tree.
std::vector<std::string> said_of_vessels(const PatientCase& patient);

// Of vessels that were made anew: ends that take most of the flow, doubtful links by hand, and what
// their making warned of. `shares` as from flow_shares().
std::vector<std::string> said_of_remade(const PatientCase& patient,
                                        const std::vector<double>& shares,
                                        std::vector<std::string> warnings);

// Of what was told those sentences that are not about the vessels or are still said of them, behind
// those that are said now for the first time.
std::vector<std::string> still_standing(const std::vector<std::string>& told,
                                        const std::vector<std::string>& said_before,
                                        const std::vector<std::string>& said_now);

}  // namespace hepatica
