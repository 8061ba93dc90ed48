// SPDX-License-Identifier: GPL-3.0-or-later
// The body that a benchmark of the solver runs on: that of a patient where --case names one.
#pragma once

#include <filesystem>

#include "app/command_line.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct CaseTree {
    std::filesystem::path file;

    // --case and --tetrahedra; `instead` says what is measured without a case.
    void add_options(CLI::App& verb, int& tetrahedra, const std::string& instead);
    // Empty without a case. Throws InputError where it cannot be read.
    VesselTree read() const;
};

}  // namespace hepatica
