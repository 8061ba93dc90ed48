// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reconstruction/system_patients.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/phantom/random_patient.h"
#include "core/tree/extraction/vessel_graph.h"
#include "core/tree/files/tree_io.h"
#include "tests/reconstruction/closed_surface.h"
#include "tests/reconstruction/segmentation_score.h"

namespace hepatica::testing_support {

namespace fs = std::filesystem;

namespace {

constexpr int most_contacts = 8;  // of a phantom whose systems touch

Mask voxels_of(const Mask& labels, VascularSystem system) {
    Mask mask = labels;
    for (std::uint8_t& voxel : mask.voxels) voxel = voxel == static_cast<std::uint8_t>(system);
    return mask;
}

VesselTree part_of(const VesselTree& tree, VascularSystem system) {
    VesselGraph graph = to_graph(tree);
    std::erase_if(graph.links, [&](const VesselLink& l) { return l.system != system; });
    return directed(std::move(graph), root_wishes(tree));
}

Phantom touching_as_often_as_it_can(PhantomOptions options, Job& job) {
    for (options.touching = most_contacts; options.touching > 1; --options.touching) {
        try {
            return make_phantom(options, job);
        } catch (const InputError&) {  // one place less
        }
    }
    return make_phantom(options, job);
}

// In LPS millimetres, with room around it.
Grid grid_around(const ClosedSurface& surface) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : surface.points_mm) box.extend(p);
    constexpr double margin_mm = 15.0;
    Grid grid;
    grid.spacing_mm = Vec3(0.8, 0.8, 1.0);
    grid.origin_mm = box.min() - Vec3::Constant(margin_mm);
    for (int axis = 0; axis < 3; ++axis)
        grid.dims[axis] = static_cast<int>(
            std::ceil((box.sizes()[axis] + 2.0 * margin_mm) / grid.spacing_mm[axis]));
    return grid;
}

struct Enhanced {
    VascularSystem system;
    const char* file;
    float hu;
};

constexpr std::array enhanced{Enhanced{VascularSystem::portal, "portal_vein.vtk", 165.0f},
                              Enhanced{VascularSystem::hepatic, "hepatic_veins.vtk", 158.0f},
                              Enhanced{VascularSystem::artery, "arteries.vtk", 172.0f}};
constexpr float parenchyma_hu = 108.0f, outside_hu = -60.0f;

}  // namespace

SystemPatient patient_of_ircadb(const std::string& name, Job& job) {
    const fs::path folder = data_folder() / name;
    SystemPatient patient{name, folder / "PATIENT_DICOM", folder / "masks/liver.nii.gz", {}, {}};
    patient.truths = {
        {VascularSystem::portal, read_mask(folder / "masks/portalvein.nii.gz", job), {}},
        {VascularSystem::hepatic, read_mask(folder / "masks/venoussystem.nii.gz", job), {}}};
    patient.liver = read_mask(patient.liver_mask, job);
    return patient;
}

SystemPatient patient_of_vascusynth(Job& job) {
    const fs::path folder = data_folder() / "vascusynth";
    SystemPatient patient{
        "vascusynth", folder / "phantom_ct_hu.nii.gz", folder / "phantom_labels.nii.gz", {}, {}};
    for (const auto& [system, name] : {std::pair{VascularSystem::portal, "portal"},
                                       {VascularSystem::hepatic, "hvein"},
                                       {VascularSystem::artery, "artery"}})
        patient.truths.push_back(
            {system, read_mask(folder / ("mask_" + std::string(name) + ".nii.gz"), job),
             read_tree(folder / ("tree_" + std::string(name) + ".vtp"),
                       {.space = PatientSpace::lps})});
    return patient;
}

SystemPatient patient_of_surfaces(const fs::path& folder, Job& job) {
    const fs::path models = data_folder() / "sksurgery_liver/models";
    SystemPatient patient{"sksurgery_liver", folder / "ct.nii.gz", folder / "liver.nii.gz", {}, {}};
    const ClosedSurface organ = read_surface(models / "liver.vtk");
    const Image<std::uint8_t> liver = inside_share(organ, grid_around(organ));
    FloatVolume image(liver.grid, outside_hu);
    patient.liver = Mask(liver.grid);
    std::vector<Image<std::uint8_t>> shares;
    for (const Enhanced& vessel : enhanced) {
        shares.push_back(inside_share(read_surface(models / vessel.file), liver.grid));
        patient.truths.push_back({vessel.system, Mask(liver.grid), {}});
    }
    for (std::size_t i = 0; i < image.voxels.size(); ++i) {
        patient.liver->voxels[i] = liver.voxels[i] >= 32;
        image.voxels[i] += (parenchyma_hu - outside_hu) * static_cast<float>(liver.voxels[i]) / 64;
        std::size_t most = 0;  // where lumens overlap, the one that fills most of the voxel
        for (std::size_t s = 1; s < shares.size(); ++s)
            if (shares[s].voxels[i] > shares[most].voxels[i]) most = s;
        const int share = shares[most].voxels[i];
        image.voxels[i] += (enhanced[most].hu - image.voxels[i]) * static_cast<float>(share) / 64;
        patient.truths[most].mask.voxels[i] = share >= 32;
    }
    gaussian_smooth(image, Vec3::Constant(0.6), job);
    Volume ct(image.grid);
    std::ranges::transform(image.voxels, ct.voxels.begin(),
                           [](float hu) { return static_cast<std::int16_t>(std::lround(hu)); });
    add_noise(ct, 10.0, 1, job);
    fs::create_directories(folder);
    write_nifti(patient.ct, ct);
    write_nifti(patient.liver_mask, *patient.liver);
    return patient;
}

SystemPatient touching_phantom(std::uint64_t seed, const fs::path& folder, Job& job) {
    PhantomOptions options;
    options.seed = seed;
    options.systems = 2;
    options.hepatic_contrast_hu = options.contrast_hu - static_cast<double>(seed * 7 % 16);
    const Phantom phantom = touching_as_often_as_it_can(options, job);
    SystemPatient patient{"touching phantom " + std::to_string(seed),
                          folder / "ct.nii.gz",
                          folder / "liver.nii.gz",
                          {},
                          {}};
    for (const VascularSystem system : {VascularSystem::portal, VascularSystem::hepatic})
        patient.truths.push_back(
            {system, voxels_of(phantom.vessels, system), part_of(phantom.tree, system)});
    fs::create_directories(folder);
    write_nifti(patient.ct, phantom.ct);
    write_nifti(patient.liver_mask, phantom.liver);
    return patient;
}

SystemPatient randomised_patient(std::uint64_t number, const fs::path& folder, Job& job) {
    const Phantom phantom = make_phantom(random_patient(number), job);
    SystemPatient patient{"randomised patient " + std::to_string(number),
                          folder / "ct.nii.gz",
                          folder / "liver.nii.gz",
                          {},
                          phantom.liver};
    for (const VascularSystem system :
         {VascularSystem::portal, VascularSystem::hepatic, VascularSystem::artery}) {
        VesselTree tree = part_of(phantom.tree, system);
        if (!tree.segments.empty())
            patient.truths.push_back({system, voxels_of(phantom.vessels, system), std::move(tree)});
    }
    fs::create_directories(folder);
    write_nifti(patient.ct, phantom.ct);
    write_nifti(patient.liver_mask, sloppy_liver(phantom.liver, number, job));
    return patient;
}

}  // namespace hepatica::testing_support
