// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the studies as they are today, times left out: rows of every suite of extremes, the
// bodies that studies are made of, and what the small ones of them measure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/study/extremes.h"
#include "core/study/hand_motion.h"
#include "core/study/iteration_study.h"
#include "core/study/pull_trial.h"
#include "core/study/reference_beam.h"
#include "core/study/region_study.h"
#include "core/study/step_study.h"
#include "core/study/tear_study.h"
#include "core/study/touch_bodies.h"
#include "core/study/tradeoff.h"
#include "core/study/vessel_body.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

std::span<const std::uint8_t> letters(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void append_points(std::vector<double>& to, std::span<const Vec3> points) {
    for (const Vec3& p : points) to.insert(to.end(), p.begin(), p.end());
}

void add_body(Figures& figures, const std::string& name, const BodyDescription& body) {
    std::vector<double> points, elements;
    append_points(points, body.mesh.vertices_mm);
    for (const auto& t : body.mesh.tetrahedra) elements.insert(elements.end(), t.begin(), t.end());
    for (const auto& h : body.hexahedra) elements.insert(elements.end(), h.begin(), h.end());
    figures.add(name + ".points", points)
        .add(name + ".elements", elements)
        .add(name + ".fixed", body.fixed)
        .add(name + ".stiffness", body.stiffness_factor)
        .add(name + ".density", body.density_factor)
        .add(name + ".skeleton", body.skeleton.radii_mm)
        .add(name + ".material",
             std::vector{body.material.young_modulus_pa, body.material.poisson_ratio,
                         body.material.density_g_mm3, body.material.damping_ratio,
                         body.tether_pa_per_mm2});
}

// What each row says but energies that are rounding alone.
void add_rows(Figures& figures, const std::string& name, const std::vector<ExtremeRow>& rows) {
    std::vector<double> numbers;
    std::string words;
    for (const ExtremeRow& row : rows) {
        for (const int value :
             {int(row.survived), int(row.refused), row.touched_steps, row.splits,
              row.inverted_splits, row.touching_splits, row.degraded_steps, row.unresolved_steps})
            numbers.push_back(value);
        if (std::isfinite(row.error)) numbers.push_back(row.error);
        words += row.name + "|" + row.reference + "|" + (row.refused ? row.note : "") + "\n";
    }
    figures.add(name + ".rows", static_cast<double>(rows.size()))
        .add(name + ".numbers", numbers)
        .add(name + ".words", letters(words));
}

TEST(StudyFigures, OfExtremes) {
    Job job;
    const std::vector<ExtremeCase> all = extreme_cases();
    std::string names;
    for (const ExtremeCase& one : all) names += one.name + "\n";
    Figures figures;
    figures.add("names", letters(names));
    // The quick ones of every suite.
    for (const auto& [name, filter] :
         {std::pair{"refused", "refuse"}, std::pair{"flat", "flat"}, std::pair{"tool", "tool"},
          std::pair{"spring", "spring E=1e+06 dt=0.1"}, std::pair{"jump", "grab jumps"}})
        add_rows(figures, name, run_extremes(all, filter, job));
    Campaign campaign;
    campaign.seed = 5;
    campaign.trials = 2;
    campaign.steps = 12;
    campaign.most_tetrahedra = 500;
    add_rows(figures, "touch", run_extremes(touch_cases(campaign), "", job));
    add_rows(figures, "tear", run_extremes(tear_cases(campaign), "", job));
    expect_recorded("study", "extremes", figures);
}

// Of every row the first step after each thing that it does: no place, speed, force or mesh of it
// changes unseen. Most rows then say that they were not given time, in words with figures.
TEST(StudyFigures, OfTheBeginningsOfEveryExtreme) {
    std::vector<ExtremeCase> cases = extreme_cases();
    const Campaign campaign{.seed = 9, .trials = 6, .steps = 33, .most_tetrahedra = 300};
    for (const auto& more : {touch_cases(campaign), tear_cases(campaign)})
        cases.insert(cases.end(), more.begin(), more.end());
    ExtremeRun how;
    how.most_steps = 1;
    std::vector<double> paths, errors, steps;
    std::string words;
    for (const ExtremeCase& one : cases) {
        ExtremeRow row;
        try {
            row = one.run(how);
        } catch (const Error& refusal) {
            row.note = refusal.what();
        }
        // Rows move between a billionth of a millimetre and kilometres in a step.
        const bool moves = row.path_mm > 1e-13 && std::isfinite(row.path_mm);
        paths.push_back(moves ? std::log(row.path_mm) : 0.0);
        errors.push_back(std::isfinite(row.error) ? std::min(row.error, 2.0) : -1.0);
        steps.push_back(row.degraded_steps);
        steps.push_back(row.touched_steps);
        words += row.reference + "|";
        for (const char letter : row.note)
            if (std::isalpha(static_cast<unsigned char>(letter)) && letter != 'e') words += letter;
        words += "\n";
    }
    expect_recorded("study", "beginnings",
                    Figures()
                        .add("paths", paths)
                        .add("errors", errors)
                        .add("steps", steps)
                        .add("words", letters(words)));
}

TEST(StudyFigures, OfBodies) {
    Job job;
    Figures figures;
    add_body(figures, "bar", study_bar(8.0, 3));
    const VesselTree tree = study_tree(3, 5.0);
    add_body(figures, "tree", body_of(tree, 900, job));
    std::mt19937_64 random(77);
    const VesselTree drawn = random_study_tree(random);
    const VesselTree knot = open_knot(2.0);
    for (const VesselTree* one : {&tree, &drawn, &knot}) {
        std::vector<double> points, radii;
        for (const VesselSegment& segment : one->segments) {
            append_points(points, segment.points_mm);
            radii.insert(radii.end(), segment.radii_mm.begin(), segment.radii_mm.end());
            radii.push_back(segment.parent);
        }
        const std::string name = one == &tree ? "study" : one == &drawn ? "drawn" : "knot";
        figures.add(name + ".points", points).add(name + ".radii", radii);
    }
    const BodyDescription body = body_of(tree, 900, job);
    std::vector<double> places;
    append_points(places, std::vector{clamp_mm(body)});
    places.push_back(furthest_vertex(body));
    for (const int frame : {0, 1, 17, 60, 200}) {
        const Grab grab = led_around(furthest_vertex(body), Vec3(1, 2, 3), frame);
        append_points(places, std::vector{grab.target_mm});
        places.push_back(grab.stiffness_un_per_mm);
        places.push_back(grab.force_limit_un);
    }
    append_points(places, bent(body.mesh.vertices_mm, 0.7));
    const Pull pull(body);
    for (const int frame : {0, 10, 30, 45, 59})
        for (const Grab& grab : pull.grabs(body, frame)) {
            append_points(places, std::vector{grab.target_mm});
            for (std::size_t k = 0; k < 4; ++k) {
                places.push_back(grab.vertices[k]);
                places.push_back(grab.weights[k]);
            }
            places.push_back(grab.stiffness_un_per_mm);
            places.push_back(grab.force_limit_un);
        }
    figures.add("places", places);
    for (const char* name : {"spring", "corotated", "neohookean-10", "hexahedron"}) {
        BeamSpec spec;
        spec.cells = {4, 2, 1};
        const BodyDescription beam = clamped_beam(spec, discretisation_of(name));
        add_body(figures, std::string("beam.") + name, beam);
        figures.add(std::string("beam.") + name + ".theory",
                    std::vector{timoshenko_tip_mm(spec), first_period_s(spec)});
    }
    expect_recorded("study", "bodies", figures);
}

TEST(StudyFigures, OfHandMotions) {
    std::string words;
    Figures figures;
    for (const std::string& name : hand_motion_names()) {
        if (name == "script") continue;
        const HandMotion motion = hand_motion(name);
        figures.add(name + ".steps", motion.steps);
        words += motion.name + "\n";
    }
    const HandMotion dial = dial_motion();
    figures.add("dial.steps", dial.steps).add("words", letters(words + dial.name));
    expect_recorded("study", "motions", figures);
}

TEST(StudyFigures, OfStepsRegionsAndIterations) {
    Job job;
    Figures figures;
    std::vector<double> numbers;
    StepStudyOptions steps;
    steps.tetrahedra = 700;
    steps.frames = 12;
    steps.threads = {1, 2};
    steps.gravity_mm_s2 = 3000.0;
    for (const StepRow& row : study_steps(steps, job))
        for (const double value :
             {double(row.threads), double(row.tetrahedra), row.iterations, row.newton_iterations})
            numbers.push_back(value);
    figures.add("steps", numbers);
    numbers.clear();
    RegionStudyOptions region;
    region.frames = 20;
    region.frames_after = 8;
    region.generations = {3};
    for (const RegionRow& row : study_region(region, job))
        for (const double value : {double(row.tetrahedra), double(row.live_tetrahedra),
                                   row.difference_mm, row.rms_difference})
            numbers.push_back(value);
    figures.add("region", numbers);
    numbers.clear();
    std::string words;
    IterationStudyOptions iterations;
    iterations.quick = true;
    iterations.tetrahedra = 600;
    for (const IterationRow& row : study_iterations(iterations, job)) {
        words += row.body + "|" + row.solver + "\n";
        for (const double value :
             {row.slenderness, double(row.tetrahedra), double(row.iterations_10pct),
              double(row.iterations_1pct), double(row.iterations_stopped)})
            numbers.push_back(value);
    }
    figures.add("iterations", numbers).add("iterations.words", letters(words));
    expect_recorded("study", "measured", figures);
}

// A budget in which nothing fits lists every setting, and why it was not measured.
TEST(StudyFigures, OfTheSettingsOfATradeoff) {
    Job job;
    TradeoffOptions options;
    options.budget_s = 1e-6;
    std::vector<double> numbers;
    std::string words;
    for (const TradeoffPoint& point : measure_beam_tradeoff(options, job).points) {
        words += point.element + "|" + point.region + "|" +
                 std::string(name_of(point.options.solver)) + "\n";
        for (const double value :
             {double(point.elements), double(point.options.substeps),
              double(point.options.newton_iterations), point.options.linear.energy_tolerance,
              double(point.options.linear.max_iterations), double(point.options.published)})
            numbers.push_back(value);
    }
    expect_recorded("study", "settings",
                    Figures().add("numbers", numbers).add("words", letters(words)));
}

TEST(StudyFigures, OfTears) {
    Job job;
    TearStudyOptions options;
    options.edges_mm = {2.0};
    options.tear_factors = {0.7};
    options.step_mm = 0.1;
    std::vector<double> numbers;
    std::string words;
    for (const TearRow& row : study_tear(options, job)) {
        words += row.law + "|" + row.stop + "\n";
        for (const double value :
             {row.tear_factor, row.edge_mm, double(row.tetrahedra), row.force_max_un, row.work_nj,
              row.opened_mm2, double(row.vertices_split), double(row.pieces),
              row.entropy_produced_max_nats, double(row.samples.size())})
            numbers.push_back(value);
    }
    expect_recorded("study", "tears", Figures().add("rows", numbers).add("words", letters(words)));
}

}  // namespace
}  // namespace hepatica
