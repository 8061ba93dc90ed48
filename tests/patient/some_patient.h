// SPDX-License-Identifier: GPL-3.0-or-later
// A small patient with something of everything that a case keeps.
#pragma once

#include <string>

#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"
#include "tests/mesh/random_tree.h"

namespace hepatica::test {

inline PatientCase some_patient() {
    PatientCase patient;
    Job job;
    patient.tree = random_tree(1, 2, 3.0);
    patient.mesh = tetrahedralize(patient.tree, {}, job);
    patient.surface = surface_of(patient.mesh).mesh;
    Grid grid;
    grid.dims = {6, 5, 4};
    grid.spacing_mm = Vec3(0.7, 0.8, 1.5);
    grid.origin_mm = Vec3(-10.25, 20.5, -1000.125);
    patient.mask = Mask(grid);
    patient.mask.at(2, 2, 2) = 1;
    patient.mask.at(3, 2, 2) = 2;  // another system
    patient.skeleton = Mask(grid);
    patient.skeleton.at(2, 2, 2) = 1;
    patient.organs = Mask(grid, organ_label::liver);
    patient.organs.at(1, 1, 1) = organ_label::cava;
    patient.source.name = "Case wïth spaces";
    patient.source.image_sha256 = std::string(64, 'a');
    patient.source.image_grid = grid;
    patient.source.parameters_json = R"({"refinement_recursions":2})";
    return patient;
}

}  // namespace hepatica::test
