// SPDX-License-Identifier: GPL-3.0-or-later
// The tree that a solver benchmark runs on: a patient's where --case names one.
#pragma once

#include <filesystem>

#include "app/command_line.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct CaseTree {
    std::filesystem::path file;

    void add_options(CLI::App& verb, int& tetrahedra, const std::string& instead);
    // Empty without a case. Throws InputError where the case cannot be read.
    VesselTree read() const;
};

}  // namespace hepatica
