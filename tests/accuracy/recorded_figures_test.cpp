// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of judgements as they are today: a synthetic patient's tree and mask, moved, thinned and
// mixed up, against the truth that it was drawn from.
#include <gtest/gtest.h>

#include <cmath>

#include "core/accuracy/accuracy.h"
#include "core/accuracy/surface_dice.h"
#include "core/accuracy/system_scores.h"
#include "core/phantom/phantom.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

const Phantom& judged_patient() {
    static const Phantom phantom = [] {
        PhantomOptions options;
        options.seed = 9;
        options.generations = 4;
        options.systems = 2;
        options.touching = 1;
        options.dims = {84, 76, 68};
        options.spacing_mm = {1.4, 1.4, 1.6};
        Job job;
        return make_phantom(options, job);
    }();
    return phantom;
}

// Moved a little, with thinner vessels, a branch of the wrong system and one that is missing.
VesselTree mistaken_tree() {
    VesselTree tree = judged_patient().tree;
    const Vec3 shift(0.9, -0.6, 0.7);
    for (VesselNode& node : tree.nodes) node.position_mm += shift;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        VesselSegment& segment = tree.segments[s];
        for (Vec3& point : segment.points_mm) point += shift;
        for (double& radius : segment.radii_mm) radius *= 0.85;
        if (s % 5 == 3)
            segment.system = segment.system == VascularSystem::portal ? VascularSystem::hepatic
                                                                      : VascularSystem::portal;
    }
    tree.segments.pop_back();  // the last has no children
    return tree;
}

Mask mistaken_mask() {
    const Mask& truth = judged_patient().vessels;
    Mask mask(truth.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = truth.grid.index_of(i);
        if (x + 1 < truth.grid.dims[0]) mask.voxels[i] = truth.at(x + 1, y, z);
        if (z > 60) mask.voxels[i] = 0;
        if (mask.voxels[i] != 0 && (x + y) % 11 == 0) mask.voxels[i] = 3 - mask.voxels[i];
    }
    return mask;
}

void add_score(Figures& figures, const std::string& name, const SystemScore& score) {
    const Vec3 trunk = score.trunk_at_mm.value_or(Vec3(-1, -1, -1));
    std::vector<double> numbers{double(static_cast<int>(score.system)),
                                score.truth_length_mm,
                                score.tree_length_mm,
                                score.length_recall,
                                score.length_precision,
                                score.surface_dice.value_or(-1.0),
                                score.dice.value_or(-1.0),
                                score.root_error_mm.value_or(-1.0),
                                trunk.x(),
                                trunk.y(),
                                trunk.z()};
    for (const RadiusClass& one : score.by_radius)
        for (const double value :
             {one.from_mm, one.to_mm, one.truth_length_mm, one.tree_length_mm,
              one.length_recall.value_or(-1.0), one.length_precision.value_or(-1.0)})
            if (std::isfinite(value)) numbers.push_back(value);
    figures.add(name, numbers);
}

TEST(AccuracyFigures, OfTreesAndMasks) {
    Job job;
    const Phantom& truth = judged_patient();
    Figures figures;
    for (const double bifurcation : {-1.0, 1.5}) {
        AccuracyOptions options;
        options.bifurcation_radius_mm = bifurcation;
        options.length_radius_mm = bifurcation < 0.0 ? 0.0 : 1.2;
        const Accuracy a =
            compare(mistaken_tree(), mistaken_mask(), truth.tree, truth.vessels, options, job);
        figures.add(bifurcation < 0.0 ? "all" : "wide",
                    std::vector{a.voxel_mm, a.dice, a.cldice, a.centreline_mean_mm,
                                a.centreline_p95_mm, a.centreline_median_mm.value_or(-1.0),
                                a.truth_median_mm.value_or(-1.0), a.length_found,
                                a.radius_bias_mm.value_or(-9.0), a.radius_mae_mm.value_or(-9.0),
                                a.bifurcation_recall, a.bifurcation_precision,
                                double(a.truth_bifurcations), double(a.tree_bifurcations),
                                double(a.components), double(a.truth_components)});
    }
    Mask everywhere(truth.vessels.grid, 1);
    for (const double tolerance : {0.5, 1.0, 2.0})
        figures.add("surface" + std::to_string(tolerance),
                    surface_dice(mistaken_mask(), truth.vessels, everywhere, tolerance, job));
    expect_recorded("accuracy", "compared", figures);
}

TEST(AccuracyFigures, OfSystems) {
    Job job;
    const Phantom& truth = judged_patient();
    std::vector<SystemTruth> truths;
    for (const VascularSystem system : {VascularSystem::portal, VascularSystem::hepatic}) {
        Mask own(truth.vessels.grid);
        for (std::size_t i = 0; i < own.voxels.size(); ++i)
            own.voxels[i] = truth.vessels.voxels[i] == static_cast<std::uint8_t>(system) ? 1 : 0;
        truths.push_back({system, own, {}});
    }
    Figures figures;
    for (const double tolerance : {1.0, 2.0}) {
        SystemScoreOptions options;
        options.length_tolerance_mm = tolerance;
        options.surface_tolerance_mm = 0.5 * tolerance;
        const SystemScores scores = judge_systems(mistaken_tree(), mistaken_mask(), truths,
                                                  &truth.liver, nullptr, options, job);
        const std::string name = "within" + std::to_string(tolerance);
        for (const SystemScore& score : scores.systems)
            add_score(figures, name + "." + std::to_string(static_cast<int>(score.system)), score);
        add_score(figures, name + ".vessels", scores.vessels);
        figures.add(name + ".sums", std::vector{scores.system_right, scores.attributed_mm,
                                                double(scores.false_joins), double(scores.breaks),
                                                double(scores.loops)});
    }
    expect_recorded("accuracy", "systems", figures);
}

}  // namespace
}  // namespace hepatica
