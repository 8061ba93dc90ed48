// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in patient as an earlier start of this very program made it. A cache holds one entry,
// of the program that wrote last: a case and what else opening it says, under a digest of the
// program and of the patient's parameters. Whatever is wrong with it, it counts as absent.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"

namespace hepatica {

// Where an entry is kept, and for which program.
struct BuiltInCache {
    std::filesystem::path folder;  // the program's own in the user's cache; empty: nothing is kept
    std::string program;           // another text for every program that may make another patient
};

struct KeptPatient {
    PatientCase patient;
    std::vector<std::string> warnings;  // of its reconstruction, without line breaks
};

// There is an entry of this program; says nothing about whether it can be read. Cheap.
bool holds_patient(const BuiltInCache& cache);
// None where there is no entry of this program, or one that is damaged.
std::optional<KeptPatient> patient_of(const BuiltInCache& cache);
// Replaces what was there, whole or not at all; any number of programs may do so at once. Where it
// cannot be written, nothing happens.
void keep(const BuiltInCache& cache, const PatientCase& patient,
          std::span<const std::string> warnings);

}  // namespace hepatica
