// SPDX-License-Identifier: GPL-3.0-or-later
// Patients of whom each vascular system is known, as files that a reconstruction reads and as the
// truths that it is judged by.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/system_truth.h"

namespace hepatica::testing_support {

struct SystemPatient {
    std::string name;
    std::filesystem::path ct, liver_mask;
    std::vector<SystemTruth> truths;
    std::optional<Mask> liver;  // only what lies in it is judged; none: everything
};

// An expert's portal vein and "venous system", which holds the vena cava; `name` is a folder of the
// test data.
SystemPatient patient_of_ircadb(const std::string& name, Job& job);

// VascuSynth's three trees, which touch; judged by the trees, everywhere.
SystemPatient patient_of_vascusynth(Job& job);

// The surfaces of a real patient's vessels in a CT made of them: portal vein, hepatic veins and
// arteries at 165, 158 and 172 over 108 HU, blurred by 0.6 mm, with 10 HU of noise. Files are
// written into `folder`.
SystemPatient patient_of_surfaces(const std::filesystem::path& folder, Job& job);

// A phantom whose systems touch in eight places, or as many as its seed allows; hepatic veins 0 to
// 15 HU darker, by the seed. Judged by its trees, everywhere. Files are written into `folder`.
SystemPatient touching_phantom(std::uint64_t seed, const std::filesystem::path& folder, Job& job);

// A patient drawn at random (random_patient.h), with a sloppy mask of the liver. Judged by its
// trees, arteries among them where they are enhanced, in its liver.
SystemPatient randomised_patient(std::uint64_t number, const std::filesystem::path& folder,
                                 Job& job);

}  // namespace hepatica::testing_support
