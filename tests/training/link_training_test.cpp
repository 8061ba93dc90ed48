// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/link_training.h"

#include <gtest/gtest.h>

#include <thread>

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

}  // namespace
}  // namespace hepatica
