// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/link_training.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace hepatica {
namespace {

// Of as many patients as a training may ask for; those below a million are for judging.
TEST(LinkTraining, SeedsShareNoPatient) {
    EXPECT_GT(patient_number(1, 1), 1000000u);
    EXPECT_LT(patient_number(1, 10000), patient_number(2, 1));
    EXPECT_LT(patient_number(999999999999, 10000), patient_number(1000000000000, 1));
}

TEST(LinkTraining, RefusesSeedsWhosePatientsWouldBeOthers) {
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1000000000001}}) {
        Job job;
        EXPECT_THROW(trained_links({.seed = seed, .volumes = 1}, job), InputError);
    }
}

TEST(LinkTraining, RefusesNumbersOfPatientsThatMakeNoSense) {
    for (const int volumes : {0, -3, 10001}) {
        Job job;
        EXPECT_THROW(trained_links({.seed = 1, .volumes = volumes}, job), InputError);
    }
}

TEST(LinkTraining, HearsACancelInTheMiddleOfAPatient) {
    Job job;
    std::jthread canceller([&] {
        while (job.progress().stage_number < 1)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        job.cancel();
    });
    EXPECT_THROW(trained_links({.seed = 1, .volumes = 3}, job), Cancelled);
}

// 150 pieces whose features follow from the patient's number; wide ones are vessels.
std::vector<TaughtPiece> some_pieces(std::uint64_t number, double, Job&) {
    std::vector<TaughtPiece> pieces(150);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = 0; k < pieces[i].features.size(); ++k)
            pieces[i].features[k] = static_cast<float>((number + 7 * i + 13 * k * i) % 101);
        pieces[i].share = pieces[i].features[0] > 50.0f ? 1.0f : 0.0f;
    }
    return pieces;
}

// Each number of each node, tree by tree.
std::vector<double> numbers_of(const LinkModel& model) {
    std::vector<double> numbers;
    for (const auto& tree : model.forest.trees)
        for (const ForestNode& node : tree)
            for (const double number :
                 {1.0 * node.feature, node.value, 1.0 * node.up_to, 1.0 * node.above})
                numbers.push_back(number);
    return numbers;
}

TEST(LinkTraining, LeavesOutAPatientThatIsRefusedAndSaysWhich) {
    const std::uint64_t refused = patient_number(3, 2);
    const Teacher refuses = [&](std::uint64_t number, double share, Job& job) {
        if (number == refused) throw InputError("is too thin", "the liver", "Grow another");
        return some_pieces(number, share, job);
    };
    const Teacher lacks = [&](std::uint64_t number, double share, Job& job) {
        return number == refused ? std::vector<TaughtPiece>{} : some_pieces(number, share, job);
    };
    std::vector<std::pair<std::uint64_t, std::string>> left_out;
    const auto note = [&](std::uint64_t number, const InputError& reason) {
        left_out.emplace_back(number, reason.problem());
    };
    Job job;
    const LinkModel model = trained_links({.seed = 3, .volumes = 4}, job, note, refuses);
    EXPECT_EQ(left_out, (std::vector<std::pair<std::uint64_t, std::string>>{
                            {patient_number(3, 2), "is too thin"}}));
    EXPECT_EQ(job.stage_times().size(), 5u) << "each patient, and the forest";
    Job other;
    EXPECT_EQ(numbers_of(model),
              numbers_of(trained_links({.seed = 3, .volumes = 4}, other, {}, lacks)));
    Job whole;
    EXPECT_NE(numbers_of(model),
              numbers_of(trained_links({.seed = 3, .volumes = 4}, whole, {}, some_pieces)));
}

TEST(LinkTraining, EndsWhereNoPatientIsLeft) {
    const Teacher refuses = [](std::uint64_t number, double, Job&) -> std::vector<TaughtPiece> {
        throw InputError("number " + std::to_string(number) + " is too thin", "the liver", "");
    };
    int left_out = 0;
    Job job;
    try {
        trained_links(
            {.seed = 1, .volumes = 3}, job, [&](std::uint64_t, const InputError&) { ++left_out; },
            refuses);
        FAIL() << "it learned of nothing";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(),
                  "all 3 patients were refused, the last one because: the liver: number 1000003 is "
                  "too thin");
        EXPECT_EQ(error.place(), "--volumes");
    }
    EXPECT_EQ(left_out, 3);
}

// What is no refusal ends it, as a cancel does.
TEST(LinkTraining, EndsWithEverythingElseThatAPatientThrows) {
    const Teacher fails = [](std::uint64_t, double, Job&) -> std::vector<TaughtPiece> {
        throw std::logic_error("a fault of the program");
    };
    Job job;
    EXPECT_THROW(trained_links({.seed = 1, .volumes = 3}, job, {}, fails), std::logic_error);
    const Teacher cancels = [](std::uint64_t, double, Job&) -> std::vector<TaughtPiece> {
        throw Cancelled();
    };
    Job cancelled;
    EXPECT_THROW(trained_links({.seed = 1, .volumes = 3}, cancelled, {}, cancels), Cancelled);
}

}  // namespace
}  // namespace hepatica
