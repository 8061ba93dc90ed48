// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes case.json: what a case was made from and how, its tree in numbers, and the
// digests of its files.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"

namespace hepatica {

// Names of the files of a case.
namespace case_file {
inline constexpr const char* header = "case.json";
inline constexpr const char* mask = "mask.nii.gz";
inline constexpr const char* skeleton = "skeleton.nii.gz";
inline constexpr const char* organs = "organs.nii.gz";
inline constexpr const char* unpainted = "organs_unpainted.nii.gz";
inline constexpr const char* couinaud = "couinaud.nii.gz";
inline constexpr const char* tree = "tree.vtp";
inline constexpr const char* swc = "tree.swc";
inline constexpr const char* surface = "surface.vtp";
inline constexpr const char* mesh = "mesh.vtu";
inline constexpr const char* corrections = "corrections.json";
inline constexpr const char* extracted = "tree_extracted.vtp";
inline constexpr const char* dial = "dial.json";
inline constexpr const char* measurements = "measurements.json";
inline constexpr std::array all{header,      mask,      skeleton, organs,      unpainted,
                                couinaud,    tree,      swc,      surface,     mesh,
                                corrections, extracted, dial,     measurements};
}  // namespace case_file

struct CaseHeader {
    int version = 0;
    CaseSource source;
    std::optional<Doubts> doubts;
    std::vector<std::string> warnings;  // as in PatientCase
    std::size_t warnings_of_image = 0;
    // Grid of mask and skeleton in double precision, which their files lack; none in older cases.
    std::optional<Grid> mask_grid;
    std::map<std::string, std::string> digests;  // by file name: SHA-256; format 1: another hash
};

// Throws InputError that the case cannot be used, with the place and the problem.
[[noreturn]] void refuse_case(const std::filesystem::path& place, const std::string& problem);

// Reads case.json of a case. Throws InputError where it is missing, damaged or of an unknown
// version.
CaseHeader read_case_header(const std::filesystem::path& folder);

// Throws InputError where a file of the case is missing or its digest is not that in case.json.
void check_case_file(const std::filesystem::path& folder, const CaseHeader& header,
                     const char* name);

// Writes case.json for the files that lie in the folder already. Throws InputError where it cannot
// be written.
void write_case_header(const std::filesystem::path& folder, const PatientCase& patient);

}  // namespace hepatica
