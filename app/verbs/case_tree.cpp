// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/case_tree.h"

#include "core/patient/patient_case.h"

namespace hepatica {

void CaseTree::add_options(CLI::App& verb, int& tetrahedra, const std::string& instead) {
    verb.add_option("--case", file, "A patient's case; without it " + instead);
    verb.add_option("--tetrahedra", tetrahedra, "Of the tree, about so many")
        ->check(CLI::Range(1000, 1000000));
}

VesselTree CaseTree::read() const {
    return file.empty() ? VesselTree{} : read_case_without_voxels(file).tree;
}

}  // namespace hepatica
