// SPDX-License-Identifier: GPL-3.0-or-later
// Patients with a truth, and how well a segmentation meets it. Shared by the tests, which hold
// floors, and by the program segmentation_scores, which prints everything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "core/tree/vessel_tree.h"

namespace hepatica::testing_support {

struct Patient {
    std::string name;
    Volume ct;
    Mask liver;       // as the expert drew it
    Mask truth;       // vessels
    Mask judged;      // where they are scored: the closed liver
    VesselTree tree;  // of the truth; empty where there is none
};

// Where the test data lies: the environment's HEPATICA_TEST_DATA, else ../shared/data.
std::filesystem::path data_folder();

Patient ircadb_patient(Job& job);      // truth: portal vein or venous system
Patient vascusynth_patient(Job& job);  // judged everywhere
Patient phantom_patient(const PhantomOptions& options, Job& job);
Patient phantom_patient(std::uint64_t seed, double slice_mm, Job& job);

// Noise of a CT's kind on top: Gaussian, correlated over about a pixel in the plane.
void add_noise(Volume& ct, double deviation_hu, std::uint64_t seed, Job& job);
// Every n-th slice.
Patient thinned_out(const Patient& patient, int every_nth_slice);

struct Score {
    double dice = 0.0;
    double precision = 0.0;
    double recall = 0.0;
    double cldice = 0.0;
    double centreline_precision = 0.0;  // share of the result's skeleton inside the truth
    double centreline_recall = 0.0;     // share of the truth's skeleton inside the result
};

// On the truth's grid, within patient.judged; the mask is looked up by linear interpolation.
Score score(const Mask& mask, const Patient& patient, Job& job);

// Share of the length of the truth's centrelines, of radii above radius_mm, that has the mask's
// skeleton within tolerance_mm.
double length_found(const Mask& mask, const Patient& patient, double radius_mm, double tolerance_mm,
                    Job& job);

}  // namespace hepatica::testing_support
