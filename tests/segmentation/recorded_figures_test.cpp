// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of segmentation as it is today: every step from a small synthetic CT to vessels, on its
// own.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/segmentation/fast_marching.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/hilum_vessels.h"
#include "core/segmentation/line_coherence.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/minimal_surface.h"
#include "core/segmentation/organ_surroundings.h"
#include "core/segmentation/vessel_detection.h"
#include "core/segmentation/vessel_growth.h"
#include "core/segmentation/vessel_systems.h"
#include "core/segmentation/vesselness.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

std::vector<double> numbers_of(const FloatVolume& volume) {
    return {volume.voxels.begin(), volume.voxels.end()};
}

const Phantom& small_scan() {
    static const Phantom phantom = [] {
        PhantomOptions options;
        options.seed = 6;
        options.generations = 4;
        options.systems = 2;
        options.dims = {80, 72, 64};
        options.spacing_mm = {1.5, 1.5, 1.7};
        options.noise_hu = 7.0;
        Job job;
        return make_phantom(options, job);
    }();
    return phantom;
}

struct Prepared {
    LiverFrame frame;
    TissueContrast tissue;
};

const Prepared& prepared() {
    static const Prepared made = [] {
        Job job;
        Prepared all;
        all.frame = make_liver_frame(small_scan().ct, small_scan().liver, 1.3, job);
        all.tissue = measure_tissue(all.frame.intensity, all.frame.liver, job);
        return all;
    }();
    return made;
}

TEST(SegmentationFigures, OfTheLiverAndItsTissue) {
    Job job;
    const auto& [frame, tissue] = prepared();
    const RobustSpread spread = robust_spread(frame.intensity, frame.liver);
    const OrganSurroundings around = surroundings_of(frame.liver, frame.intensity, job);
    expect_recorded(
        "segmentation", "tissue",
        Figures()
            .add("intensity", numbers_of(frame.intensity))
            .add("liver", frame.liver.voxels)
            .add("excess", numbers_of(tissue.excess))
            .add("interior", tissue.interior.voxels)
            .add("levels", std::vector{tissue.parenchyma_hu, tissue.noise_hu, spread.median,
                                       spread.deviation, around.bone, around.lung})
            .add("found", find_liver(small_scan().ct, job).liver.voxels)
            .add("closed", close_liver(small_scan().vessels, 4.0, job).voxels));
}

TEST(SegmentationFigures, OfDetection) {
    Job job;
    const auto& [frame, tissue] = prepared();
    Figures figures;
    for (const auto& [name, method] : {std::pair{"coherent", SegmentationMethod::coherent},
                                       std::pair{"vesselness", SegmentationMethod::vesselness},
                                       std::pair{"multi_layer", SegmentationMethod::multi_layer}}) {
        const Detection found = detect_vessels(tissue, frame.liver, small_scan().ct.grid.spacing_mm,
                                               {.method = method}, job);
        figures.add(std::string(name) + ".vessels", found.vessels.voxels)
            .add(std::string(name) + ".centreline", found.centreline.voxels);
        const Detection coarse =
            detect_vessels(tissue, frame.liver, Vec3(0.7, 0.7, 5.0), {.method = method}, job);
        figures.add(std::string(name) + ".coarse", coarse.vessels.voxels);
    }
    TissueContrast windowed = tissue;
    apply_window(frame, {140.0, 210.0}, windowed);
    figures.add("window.excess", numbers_of(windowed.excess))
        .add("window.threshold", windowed.threshold_hu.value_or(-1.0));
    const Hilum hilum{small_scan().tree.segments.front().points_mm.front(), Vec3(60, 60, 90),
                      tissue.parenchyma_hu, tissue.parenchyma_hu + 60.0};
    const Detection coherent = detect_vessels(tissue, frame.liver, Vec3(1.5, 1.5, 1.7), {}, job);
    const HilumVessels beyond = hilum_vessels(frame, coherent.vessels, hilum, job);
    const Vec3 trunk = beyond.trunk_mm.value_or(Vec3(-1, -2, -3));
    figures.add("hilum.vessels", beyond.vessels.voxels)
        .add("hilum.trunk", std::vector<double>{trunk.x(), trunk.y(), trunk.z()});
    expect_recorded("segmentation", "detection", figures);
}

TEST(SegmentationFigures, OfFiltersAndSurfaces) {
    Job job;
    const auto& [frame, tissue] = prepared();
    Figures figures;
    figures.add("vesselness", numbers_of(vesselness(frame.intensity, {1.0, 2.5}, job)));
    figures.add("lines", numbers_of(line_coherence(tissue.excess, tissue.interior, {}, job)));
    figures.add("bent_lines",
                numbers_of(line_coherence(
                    tissue.excess, tissue.interior,
                    {.half_length_mm = 5.0, .directions = 30, .max_bend_deg = 20}, job)));
    const Detection coherent = detect_vessels(tissue, frame.liver, Vec3(1.5, 1.5, 1.7), {}, job);
    figures.add("surface", fit_surface(frame.intensity, tissue.excess, coherent.vessels,
                                       frame.liver, tissue.noise_hu, {}, job)
                               .voxels);
    SurfaceOptions other;
    other.level_share = 0.5;
    other.data_weight = 1.4;
    other.iterations = 12;
    figures.add("other_surface", fit_surface(frame.intensity, tissue.excess, coherent.vessels,
                                             frame.liver, tissue.noise_hu, other, job)
                                     .voxels);
    expect_recorded("segmentation", "filters", figures);
}

TEST(SegmentationFigures, OfMasks) {
    Job job;
    const Mask& vessels = small_scan().vessels;
    Figures figures;
    figures.add("refined1", refine(vessels, 1, job).voxels)
        .add("refined3", refine(vessels, 3, job).voxels);
    RefinementOptions options;
    options.sigma_mm = 1.1;
    options.level = 0.4;
    options.kept_branch_mm = 1.0;
    figures.add("refined_coarsely", refine(vessels, options, job).voxels);
    options.keep_thin_branches = false;
    figures.add("refined_thin", refine(vessels, options, job).voxels);
    const SurfaceMeasure measure = measure_surface(vessels);
    figures.add("area", measure.area_mm2).add("volume", measure.volume_mm3);
    const auto& tree = small_scan().tree;
    std::vector<VesselSeed> seeds{{tree.segments.front().points_mm[1], VascularSystem::portal},
                                  {tree.segments.back().points_mm.back(), VascularSystem::hepatic}};
    figures.add("systems", label_systems(vessels, seeds, job).voxels);
    Mask strong = vessels;
    for (std::size_t i = 0; i < strong.voxels.size(); ++i)
        if (vessels.grid.index_of(i)[2] > 30) strong.voxels[i] = 0;
    figures.add("hysteresis", hysteresis(strong, vessels, 200.0).voxels)
        .add("grown", grow_within(strong, vessels, 7.0).voxels);
    for (const MarchingOrder order : {MarchingOrder::first, MarchingOrder::second}) {
        const std::string name = order == MarchingOrder::first ? "first" : "second";
        const FloatVolume distance = distance_from_boundary(vessels, order, job);
        figures.add(name + ".distance", numbers_of(distance));
        figures.add(name + ".collisions", front_collisions(distance).voxels);
        FloatVolume speed(vessels.grid, 0.2f);
        for (std::size_t i = 0; i < speed.voxels.size(); ++i)
            if (vessels.voxels[i] != 0) speed.voxels[i] = 1.0f;
        figures.add(name + ".times", numbers_of(arrival_times(
                                         speed, {vessels.grid.offset(40, 36, 30)}, order, job)));
    }
    expect_recorded("segmentation", "masks", figures);
}

}  // namespace
}  // namespace hepatica
