// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/potts_labelling.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/base/error.h"

namespace hepatica {
namespace {

PottsProblem random_problem(std::mt19937& random, int sites, int labels) {
    std::uniform_real_distribution<double> cost(-2.0, 2.0), strength(0.0, 1.5);
    std::uniform_int_distribution<int> site(0, sites - 1);
    PottsProblem problem;
    problem.labels = labels;
    for (int i = 0; i < sites; ++i) {
        problem.costs.emplace_back();
        for (int l = 0; l < labels; ++l) problem.costs.back().push_back(cost(random));
    }
    for (int t = 0; t < 2 * sites; ++t) {
        const int a = site(random), b = site(random);
        if (a != b) problem.ties.push_back({a, b, strength(random)});
    }
    return problem;
}

// Every labelling there is.
double least_energy_by_trial(const PottsProblem& problem) {
    std::vector<int> labels(problem.costs.size(), 0);
    double least = std::numeric_limits<double>::infinity();
    for (;;) {
        least = std::min(least, energy_of(problem, labels));
        std::size_t i = 0;
        while (i < labels.size() && ++labels[i] == problem.labels) labels[i++] = 0;
        if (i == labels.size()) return least;
    }
}

TEST(PottsLabelling, TwoLabelsAreTheMinimumOfAllLabellings) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        const PottsProblem problem = random_problem(random, 10, 2);
        EXPECT_NEAR(energy_of(problem, least_energy_labels(problem)),
                    least_energy_by_trial(problem), 1e-9)
            << trial;
    }
}

// Alpha expansion ends within twice the minimum for ties of this kind (Boykov et al. 2001), where
// no cost is negative; in most of these problems it finds the minimum itself.
TEST(PottsLabelling, ThreeLabelsStayWithinTheirBound) {
    std::mt19937 random(8);
    int exact = 0;
    for (int trial = 0; trial < 100; ++trial) {
        PottsProblem problem = random_problem(random, 7, 3);
        for (auto& costs : problem.costs)
            for (double& cost : costs) cost += 2.0;
        const double found = energy_of(problem, least_energy_labels(problem));
        const double least = least_energy_by_trial(problem);
        EXPECT_LE(found, 2.0 * least + 1e-9) << trial;
        if (found < least + 1e-9) ++exact;
    }
    EXPECT_GE(exact, 90);
}

TEST(PottsLabelling, ATieStrongerThanTheEvidenceHolds) {
    PottsProblem problem;
    problem.costs = {{0.0, 3.0}, {1.0, 0.0}};
    problem.ties = {{0, 1, 0.9}};
    EXPECT_EQ(least_energy_labels(problem), (std::vector<int>{0, 1}));
    problem.ties = {{0, 1, 1.1}};
    EXPECT_EQ(least_energy_labels(problem), (std::vector<int>{0, 0}));
}

TEST(PottsLabelling, HearsACancel) {
    std::mt19937 random(9);
    Job job;
    job.cancel();
    EXPECT_THROW(least_energy_labels(random_problem(random, 10, 2), job), Cancelled);
}

TEST(PottsLabelling, NothingHasNoLabels) {
    EXPECT_TRUE(least_energy_labels({}).empty());
}

}  // namespace
}  // namespace hepatica
