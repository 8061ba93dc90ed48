// SPDX-License-Identifier: GPL-3.0-or-later
// Generates the phantom and reconstructs it with a seed in the middle of its portal trunk.
#include "core/reconstruction/built_in_patient.h"

#include "core/image/volume_writer.h"
#include "core/reconstruction/reconstruct_parameters.h"

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

std::string built_in_parameters() {
    return parameters_json(built_in_options({}));
}

Reconstruction reconstruct_built_in(const std::filesystem::path& folder, Job& job) {
    job.expect_stages(built_in_stage_count());
    const Phantom truth = built_in_truth(job);
    ReconstructOptions options = built_in_options(folder);
    const VesselSegment& trunk = truth.tree.segments[roots(truth.tree).front()];
    options.seeds.front().position_mm = trunk.points_mm[trunk.points_mm.size() / 2];
    write_nifti(options.ct, truth.ct);
    write_nifti(*options.liver_mask, truth.liver);
    return reconstruct(options, job);
}

Phantom built_in_truth(Job& job) {
    return make_phantom(PhantomOptions{}, job);
}

}  // namespace hepatica
