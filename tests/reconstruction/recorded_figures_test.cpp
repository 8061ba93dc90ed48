// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of reconstructions as they are today: small phantoms segmented in every way, and one
// taken from CT to mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/mask_of_tree.h"
#include "core/reconstruction/reconstruct.h"
#include "core/reconstruction/round_lumen.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

// Of a child's size, so that there are few voxels.
PhantomOptions child_options() {
    PhantomOptions options;
    options.seed = 4;
    options.generations = 4;
    options.dims = {76, 68, 64};
    options.spacing_mm = {1.5, 1.5, 1.6};
    options.noise_hu = 8.0;
    return options;
}

std::span<const std::uint8_t> letters_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::vector<double> numbers_of(const Vec3& point) {
    return {point.x(), point.y(), point.z()};
}

void add_tree_points(Figures& figures, const std::string& name, const VesselTree& tree) {
    std::vector<double> numbers, radii;
    for (const VesselSegment& s : tree.segments) {
        for (const int value : {s.proximal_node, s.distal_node, s.parent,
                                static_cast<int>(s.system), s.strahler_order})
            numbers.push_back(value);
        for (const Vec3& point : s.points_mm)
            numbers.insert(numbers.end(), point.begin(), point.end());
        radii.insert(radii.end(), s.radii_mm.begin(), s.radii_mm.end());
    }
    figures.add(name + ".tree", numbers).add(name + ".radii", radii);
}

void add_segmentation(Figures& figures, const std::string& name, const Volume& ct,
                      const SegmentationOptions& options) {
    Job job;
    std::string words;
    try {
        const Segmentation found = segment_vessels(ct, options, job);
        figures.add(name + ".mask", found.mask.voxels)
            .add(name + ".liver", found.liver.voxels)
            .add(name + ".centreline", found.centreline.voxels)
            .add(name + ".origin", numbers_of(found.mask.grid.origin_mm))
            .add(name + ".spacing", numbers_of(found.mask.grid.spacing_mm))
            .add(name + ".statistics",
                 std::vector{found.statistics.parenchyma_hu, found.statistics.noise_hu,
                             found.statistics.vessel_hu, found.statistics.contrast_hu()})
            .add(name + ".components", found.components)
            .add(name + ".trunk", numbers_of(found.trunk_mm.value_or(Vec3(-1, -1, -1))));
        for (const std::string& warning : found.warnings) words += warning + "\n";
    } catch (const InputError& error) {
        words = error.problem() + "\n" + error.place() + "\n" + error.remedy();
    }
    figures.add(name + ".words", letters_of(words));
}

TEST(ReconstructionFigures, OfSegmentations) {
    Job job;
    Figures figures;
    const Phantom phantom = make_phantom(child_options(), job);
    SegmentationOptions options;
    options.liver = phantom.liver;
    add_segmentation(figures, "default", phantom.ct, options);
    options.spacing_mm = 1.4;
    for (const auto& [name, method] : {std::pair{"vesselness", SegmentationMethod::vesselness},
                                       std::pair{"multi_layer", SegmentationMethod::multi_layer}}) {
        options.method = method;
        add_segmentation(figures, name, phantom.ct, options);
    }
    options.method = SegmentationMethod::coherent;
    options.refinement_recursions = 2;
    add_segmentation(figures, "refined", phantom.ct, options);
    options.refinement_recursions = 0;
    for (const double low : {135.0, 174.0, 260.0}) {
        options.window_hu = {low, 300.0};
        add_segmentation(figures, "window" + std::to_string(low), phantom.ct, options);
    }
    expect_recorded("reconstruction", "segmentations", figures);
}

// From what is no contrast to what is plenty, against the same noise: on both sides of every limit.
TEST(ReconstructionFigures, OfWeakContrast) {
    Job job;
    Figures figures;
    for (const double contrast : {14.0, 18.0, 30.0, 38.0, 60.0}) {
        PhantomOptions made = child_options();
        made.contrast_hu = contrast;
        const Phantom phantom = make_phantom(made, job);
        SegmentationOptions options;
        options.liver = phantom.liver;
        options.spacing_mm = 1.4;
        add_segmentation(figures, "contrast" + std::to_string(contrast), phantom.ct, options);
    }
    expect_recorded("reconstruction", "contrasts", figures);
}

TEST(ReconstructionFigures, FromCtToMesh) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica recorded patient";
    fs::create_directories(folder);
    Job job;
    PhantomOptions made = child_options();
    made.systems = 2;
    const Phantom phantom = make_phantom(made, job);
    write_nifti(folder / "ct.nii.gz", phantom.ct);
    write_nifti(folder / "liver.nii.gz", phantom.liver);
    write_nifti(folder / "vessels.nii.gz", phantom.vessels);
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.liver_mask = folder / "liver.nii.gz";
    options.mesh.target_tetrahedra = 1500;
    options.spacing_mm = 1.2;
    Figures figures;
    for (const bool given : {false, true}) {
        if (given) options.vessel_mask = folder / "vessels.nii.gz";
        const Reconstruction result = reconstruct(options, job);
        const std::string name = given ? "given" : "found";
        std::string words;
        for (const std::string& warning : result.warnings) words += warning + "\n";
        for (const VoxelCounts* counts : {&result.checks.mask, &result.checks.skeleton})
            figures.add(name + (counts == &result.checks.mask ? ".of_mask" : ".of_skeleton"),
                        std::vector{static_cast<double>(counts->voxels),
                                    static_cast<double>(counts->components),
                                    static_cast<double>(counts->tunnels),
                                    static_cast<double>(counts->cavities)});
        const PatientCase& patient = result.patient;
        figures.add(name + ".mask", patient.mask.voxels)
            .add(name + ".skeleton", patient.skeleton.voxels)
            .add(name + ".organs", patient.organs.voxels)
            .add(name + ".couinaud", patient.couinaud.voxels)
            .add(name + ".crowded", static_cast<double>(result.checks.crowded_points))
            .add(name + ".tetrahedra", static_cast<double>(patient.mesh.tetrahedra.size()))
            .add(name + ".triangles", static_cast<double>(patient.surface.triangles.size()))
            .add(name + ".words", letters_of(words))
            .add(name + ".contrast", patient.doubts->contrast_hu)
            .add(name + ".noise", patient.doubts->noise_hu)
            .add(name + ".coarsest", patient.doubts->coarsest_spacing_mm);
        add_tree_points(figures, name, patient.tree);
    }
    fs::remove_all(folder);
    expect_recorded("reconstruction", "patient", figures);
}

TEST(ReconstructionFigures, OfMasksAndTheirTrees) {
    Job job;
    PhantomOptions made = child_options();
    made.systems = 2;
    const Phantom phantom = make_phantom(made, job);
    Figures figures;
    for (const double radius : {0.7, 1.0, 1.6, 9.0})
        figures.add("round" + std::to_string(radius),
                    round_thin_lumens(phantom.vessels, phantom.tree, radius, job).voxels);
    for (const bool anew : {false, true}) {
        Mask mask = phantom.vessels;
        for (std::size_t i = 0; i < mask.voxels.size(); ++i)
            if (mask.voxels[i] != 0 && i % 5 != 0) mask.voxels[i] = 255;
        follow_tree(mask, phantom.tree, anew, job);
        figures.add(anew ? "anew" : "open", mask.voxels);
    }
    expect_recorded("reconstruction", "masks", figures);
}

// A vessel with a hole, a ring on it, and crumbs beside it.
TEST(ReconstructionFigures, OfAGivenMaskWithHolesAndCrumbs) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica crumbs";
    fs::create_directories(folder);
    Volume ct(Grid{{64, 64, 24}}, 100);
    ct.voxels[0] = 50;
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.vessel_mask = folder / "vessels.nii.gz";
    options.mesh.target_tetrahedra = 800;
    write_nifti(options.ct, ct);
    Figures figures;
    for (const int crumbs : {1, 2}) {
        Mask vessels(ct.grid);
        for (std::size_t i = 0; i < vessels.voxels.size(); ++i) {
            const auto [x, y, z] = ct.grid.index_of(i);
            const bool line = std::hypot(x - 20.0, z - 12.0) < 3.2 && y > 3 && y < 60;
            const bool ring =
                std::abs(std::hypot(x - 32.0, y - 30.0) - 13.0) < 2.1 && std::abs(z - 12) < 3;
            const bool hole = std::abs(x - 20) < 2 && std::abs(y - 30) < 2 && std::abs(z - 12) < 2;
            const bool crumb = x > 56 && x < 61 && z == 4 && (y == 5 || (crumbs == 2 && y == 40));
            vessels.voxels[i] = ((line || ring) && !hole) || crumb;
        }
        write_nifti(*options.vessel_mask, vessels);
        Job job;
        const Reconstruction result = reconstruct(options, job);
        std::string words;
        for (const std::string& warning : result.warnings) words += warning + "\n";
        const std::string name = "crumbs" + std::to_string(crumbs);
        EXPECT_EQ(result.checks.mask.cavities, 0);
        figures.add(name + ".words", letters_of(words))
            .add(name + ".mask", result.patient.mask.voxels)
            .add(name + ".skeleton", result.patient.skeleton.voxels)
            .add(name + ".crowded", static_cast<double>(result.checks.crowded_points))
            .add(name + ".tunnels", static_cast<double>(result.checks.mask.tunnels));
        add_tree_points(figures, name, result.patient.tree);
    }
    fs::remove_all(folder);
    expect_recorded("reconstruction", "crumbs", figures);
}

}  // namespace
}  // namespace hepatica
