// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/built_in_patient.h"

#include "core/image/volume_writer.h"

namespace hepatica {

namespace {

ReconstructOptions built_in_options(const std::filesystem::path& folder) {
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.liver_mask = folder / "liver.nii.gz";
    options.seeds = {{Vec3::Zero(), VascularSystem::portal}};
    return options;
}

}  // namespace

int built_in_stage_count() {
    constexpr int phantom = 3;
    return phantom + stage_count(built_in_options({}));
}

BuiltInPatient reconstruct_built_in(const std::filesystem::path& folder, Job& job) {
    job.expect_stages(built_in_stage_count());
    BuiltInPatient patient;
    patient.truth = make_phantom(PhantomOptions{}, job);
    ReconstructOptions options = built_in_options(folder);
    const VesselTree& tree = patient.truth.tree;
    const VesselSegment& trunk = tree.segments[roots(tree).front()];
    options.seeds.front().position_mm = trunk.points_mm[trunk.points_mm.size() / 2];
    write_nifti(options.ct, patient.truth.ct);
    write_nifti(*options.liver_mask, patient.truth.liver);
    patient.reconstruction = reconstruct(options, job);
    return patient;
}

}  // namespace hepatica
