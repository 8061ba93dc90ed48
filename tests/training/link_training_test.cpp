// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/link_training.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/base/error.h"

namespace hepatica {
namespace {

TEST(LinkTraining, SeedsShareNoPatient) {
    EXPECT_NE(patient_number(1, 10000), patient_number(2, 0));
    EXPECT_LT(patient_number(1, 10000), patient_number(2, 1));
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
