// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of phantoms as they are today: bodies, vessels and scans.
#include <gtest/gtest.h>

#include "core/phantom/disturbances.h"
#include "core/phantom/phantom.h"
#include "core/phantom/phantom_body.h"
#include "core/phantom/phantom_contacts.h"
#include "core/phantom/phantom_growth.h"
#include "core/phantom/phantom_scan.h"
#include "core/phantom/random_patient.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

std::vector<double> numbers_in(const std::vector<Vec3>& points) {
    std::vector<double> numbers;
    for (const Vec3& point : points) numbers.insert(numbers.end(), point.begin(), point.end());
    return numbers;
}

void add_tree(Figures& figures, const std::string& name, const VesselTree& tree) {
    std::vector<double> numbers, radii;
    std::vector<Vec3> points;
    for (const VesselNode& node : tree.nodes) {
        points.push_back(node.position_mm);
        radii.push_back(node.radius_mm);
    }
    for (const VesselSegment& s : tree.segments) {
        for (const int value : {s.proximal_node, s.distal_node, s.parent, s.strahler_order,
                                static_cast<int>(s.system), s.closes_loop ? 1 : 0})
            numbers.push_back(value);
        numbers.push_back(s.system_confidence);
        points.insert(points.end(), s.points_mm.begin(), s.points_mm.end());
        radii.insert(radii.end(), s.radii_mm.begin(), s.radii_mm.end());
    }
    figures.add(name + ".segments", numbers)
        .add(name + ".points", numbers_in(points))
        .add(name + ".radii", radii);
}

void add_phantom(Figures& figures, const std::string& name, const PhantomOptions& options) {
    Job job;
    const Phantom phantom = make_phantom(options, job);
    add_tree(figures, name, phantom.tree);
    figures
        .add(name + ".ct", std::vector<double>(phantom.ct.voxels.begin(), phantom.ct.voxels.end()))
        .add(name + ".vessels", phantom.vessels.voxels)
        .add(name + ".liver", phantom.liver.voxels)
        .add(name + ".contacts", numbers_in(phantom.contacts_mm))
        .add(name + ".grid", numbers_in({phantom.ct.grid.origin_mm, phantom.ct.grid.spacing_mm}));
}

PhantomOptions coarse() {
    PhantomOptions options;
    options.seed = 901;
    options.dims = {110, 90, 62};
    options.spacing_mm = {3.1, 2.9, 3.6};
    return options;
}

TEST(PhantomFigures, WithTheOptionsAsTheyCome) {
    Figures figures;
    const PhantomOptions options;
    figures.add(
        "options",
        std::vector{static_cast<double>(options.seed), static_cast<double>(options.generations),
                    static_cast<double>(options.systems), static_cast<double>(options.touching),
                    options.root_radius_mm, options.murray_exponent, options.parenchyma_hu,
                    options.contrast_hu, options.noise_hu, options.point_spread_sigma_mm});
    figures.add("voxels", std::vector<double>(options.dims.begin(), options.dims.end()))
        .add("spacing", numbers_in({options.spacing_mm}));
    add_phantom(figures, "coarse", coarse());
    expect_recorded("phantom", "default", figures);
}

// What is brighter or darker than a scanner's numbers reach is cut off.
TEST(PhantomFigures, OfAnOverexposedScan) {
    Figures figures;
    PhantomOptions options = coarse();
    options.noise_hu = 500.0;
    options.contrast_hu = 1000.0;
    options.parenchyma_hu = 300.0;
    options.generations = 3;
    add_phantom(figures, "bright", options);
    expect_recorded("phantom", "overexposed", figures);
}

// A narrow field of view: the anatomy is scaled down.
TEST(PhantomFigures, OfASmallBody) {
    Figures figures;
    PhantomOptions options = coarse();
    options.spacing_mm = {1.2, 1.3, 1.5};
    options.systems = 2;
    options.generations = 5;
    options.murray_exponent = 2.6;
    options.root_radius_mm = 7.0;
    options.parenchyma_hu = 70.0;
    options.contrast_hu = 90.0;
    options.hepatic_contrast_hu = 40.0;
    options.noise_hu = 0.0;
    options.point_spread_sigma_mm = 0.0;
    add_phantom(figures, "sharp", options);
    options.point_spread_sigma_mm = 1.7;
    options.noise_hu = 25.0;
    options.hepatic_contrast_hu.reset();
    add_phantom(figures, "blurred", options);
    expect_recorded("phantom", "small", figures);
}

TEST(PhantomFigures, OfSystemsThatTouch) {
    Figures figures;
    PhantomOptions options = coarse();
    options.seed = 3;
    options.systems = 2;
    options.touching = 4;
    add_phantom(figures, "touching", options);
    options.generations = 7;
    options.touching = 0;
    Job job;
    VesselTree tree = make_phantom(options, job).tree;
    add_tree(figures, "apart", tree);
    figures.add("places", numbers_in(bend_to_touch(tree, 20, 77)));
    add_tree(figures, "bent", tree);
    expect_recorded("phantom", "touching", figures);
}

TEST(PhantomFigures, OfTheBody) {
    Figures figures;
    for (const std::uint64_t seed : {1u, 2u}) {
        const PhantomBody body(seed, 100.0 + 7.0 * static_cast<double>(seed));
        std::vector<double> distances, sharp, soft;
        for (double z = -120.0; z < 120.0; z += 9.7)
            for (double y = -160.0; y < 160.0; y += 6.3)
                for (double x = -210.0; x < 210.0; x += 5.9) {
                    const double distance = body.liver_distance_mm({x, y, z});
                    distances.push_back(distance);
                    sharp.push_back(body.hu({x, y, z}, distance, 0.5));
                    soft.push_back(body.hu({x, y, z}, distance, 3.0));
                }
        const std::string name = "seed" + std::to_string(seed);
        figures.add(name + ".distances", distances)
            .add(name + ".sharp", sharp)
            .add(name + ".soft", soft)
            .add(name + ".doors", numbers_in({body.portal_entry(), body.hepatic_outlet()}));
    }
    expect_recorded("phantom", "body", figures);
}

// Three trees in a ball: they grow in turns.
TEST(PhantomFigures, OfTreesThatGrowInABall) {
    std::vector<GrowthRequest> requests(3);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const double place = static_cast<double>(i);
        requests[i].root = Vec3(-40.0 + 5.0 * place, 12.0 * place - 10.0, 3.0 * place);
        requests[i].low = Vec3::Constant(-50.0);
        requests[i].high = Vec3::Constant(50.0);
        requests[i].depth_mm = [](const Vec3& p) { return 50.0 - p.norm(); };
        requests[i].ends = 40;
        requests[i].root_radius_mm = 3.0 + 0.5 * place;
        requests[i].murray_exponent = 2.5 + 0.3 * place;
    }
    PhantomRandom random(905);
    Job job;
    Figures figures;
    const std::vector<std::vector<GrownBranch>> trees = grow_trees(requests, random, job);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        std::vector<double> numbers;
        std::vector<Vec3> points;
        for (const GrownBranch& branch : trees[i]) {
            for (const int value :
                 {branch.parent, branch.children[0], branch.children[1], branch.ends})
                numbers.push_back(value);
            points.push_back(branch.begin);
            points.push_back(branch.end);
        }
        figures.add("branches" + std::to_string(i), numbers)
            .add("points" + std::to_string(i), numbers_in(points));
    }
    expect_recorded("phantom", "growth", figures);
}

// Each disturbance alone, in a ball of liver with a vessel through it.
TEST(PhantomFigures, OfDisturbances) {
    Grid grid;
    grid.dims = {46, 40, 34};
    grid.spacing_mm = {1.5, 1.6, 2.0};
    Mask liver(grid);
    Image<std::uint8_t> lumen(grid);
    const Vec3 middle = grid.to_mm(22, 20, 17);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const Vec3 off = grid.to_mm(at[0], at[1], at[2]) - middle;
        liver.voxels[i] = off.norm() < 28.0;
        lumen.voxels[i] = off.head<2>().norm() < 4.0 ? 64 : off.head<2>().norm() < 5.0 ? 20 : 0;
    }
    const std::vector<std::pair<const char*, Disturbances>> kinds{
        {"perfusion", {.perfusion_hu = 7.0}},
        {"mottle", {.mottle_hu = 5.0, .mottle_mm = 3.0}},
        {"tumours", {.tumours = 4, .tumour_hu = -35.0}},
        {"rims", {.tumours = 3, .tumour_hu = 20.0, .tumour_rim_hu = 40.0}},
        {"fissures", {.fissures = 5}},
        {"streaming", {.streaming_hu = 12.0}}};
    Job job;
    Figures figures;
    const auto add = [&](const std::string& name, const FloatVolume& image) {
        figures.add(name, std::vector<double>(image.voxels.begin(), image.voxels.end()));
    };
    for (const auto& [name, disturbances] : kinds) {
        FloatVolume image(grid, 100.0f);
        disturb_tissue(image, liver, lumen, disturbances, 100.0, 31, job);
        add(name, image);
    }
    for (const double sharpness : {0.0, 0.6})
        add(sharpness > 0.0 ? "sharp_noise" : "soft_noise",
            correlated_noise(grid, {.noise_correlation_mm = 1.2, .noise_sharpness = sharpness}, 32,
                             job));
    FloatVolume streaked(grid, 0.0f);
    add_streaks(streaked, {.streaks = 12, .streak_hu = 25.0}, 33);
    add("streaks", streaked);
    Mask sloppy = sloppy_liver(liver, 34, job);
    expect_recorded("phantom", "disturbances", figures.add("sloppy", sloppy.voxels));
}

TEST(PhantomFigures, OfCompanions) {
    Job job;
    const VesselTree tree = make_phantom(coarse(), job).tree;
    Figures figures;
    add_tree(figures, "artery", companions(tree, 0.45, Vec3::UnitX(), VascularSystem::artery));
    add_tree(figures, "duct", companions(tree, 0.3, -Vec3::UnitY(), VascularSystem::unknown));
    expect_recorded("phantom", "companions", figures);
}

TEST(PhantomFigures, OfPatientsDrawnAtRandom) {
    std::vector<double> numbers;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const PhantomOptions o = random_patient(seed);
        const Disturbances& d = o.disturbances;
        for (const double value : {double(o.generations),
                                   double(o.systems),
                                   o.root_radius_mm,
                                   o.murray_exponent,
                                   o.parenchyma_hu,
                                   o.contrast_hu,
                                   o.noise_hu,
                                   o.point_spread_sigma_mm,
                                   double(o.dims[0]),
                                   double(o.dims[2]),
                                   o.spacing_mm[0],
                                   o.spacing_mm[2],
                                   d.perfusion_hu,
                                   d.mottle_hu,
                                   d.mottle_mm,
                                   double(d.tumours),
                                   d.tumour_hu,
                                   d.tumour_rim_hu,
                                   double(d.fissures),
                                   d.artery_share,
                                   d.artery_hu,
                                   d.duct_share,
                                   d.duct_hu,
                                   d.streaming_hu,
                                   d.noise_correlation_mm,
                                   d.noise_sharpness,
                                   double(d.streaks),
                                   d.streak_hu,
                                   d.slice_spread_sigma_mm})
            numbers.push_back(value);
    }
    expect_recorded("phantom", "random", Figures().add("numbers", numbers));
}

}  // namespace
}  // namespace hepatica
