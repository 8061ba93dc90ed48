// SPDX-License-Identifier: GPL-3.0-or-later
// What a patient is called whose CT lies in a folder. Discs and archives call the folder of every
// patient alike (DICOM, ct, S0001): the folders above tell them apart.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// The name of the folder; where that says nothing, of the next one above that does, followed by the
// numbered ones between: "case07" of case07/DICOM and "case07 S0001" of case07/S0001/ct. Never the
// name of a user, of a disc or of a folder of all that was downloaded, which would say who he is or
// nothing: then it stays the folder's own. The path must be absolute.
std::string name_of_scan(const std::filesystem::path& folder);

}  // namespace hepatica
