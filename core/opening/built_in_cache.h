// SPDX-License-Identifier: GPL-3.0-or-later
// Cache of the built-in patient between starts of the program. It holds one entry, written by the
// program that ran last: the case, stored under a digest of the program and of the patient's
// parameters. An entry that is damaged or cannot be read counts as absent.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/patient/patient_case.h"

namespace hepatica {

// Where the entry lies, and for which program it is valid.
struct BuiltInCache {
    std::filesystem::path folder;  // folder of the program's own; empty: nothing is kept
    std::string program;     // text that differs between programs that may make different patients
    bool with_dial = false;  // patient_of() reads the dial that was kept in the entry, too
};

// Whether there is an entry of this program; it may still be unreadable. Reads the label only.
bool holds_patient(const BuiltInCache& cache);
// Reads the entry; its dial, which the label does not vouch for, only where the cache asks for it.
// None where there is no entry of this program or where it is damaged.
std::optional<PatientCase> patient_of(const BuiltInCache& cache);
// The case of the entry, in which what is measured of the patient may be kept. Empty where there is
// no entry of this program.
std::filesystem::path case_of(const BuiltInCache& cache);
// Replaces the entry atomically; several programs may do so at once. Failures to write are ignored.
void keep(const BuiltInCache& cache, const PatientCase& patient);

}  // namespace hepatica
