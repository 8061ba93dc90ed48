// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the steps in the window: the choice, what is said where it cannot be had, and what of
// a case's dial is left out then.
#include "ui/back_ends.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/measured_dial.h"
#include "tests/session/small_patient.h"
#include "ui/patient_loader.h"

namespace hepatica {
namespace {

using test::small_patient;

// A program on a computer without a device.
DeformBackEnd without_device(const std::string& name, const BackEnds::Say& say) {
    if (name == "cuda") throw InputError("there is none", "the CUDA back end", "Buy one");
    if (name == "auto") say("The processor makes the steps: there is none");
    return cpu_back_end();
}

class BackEndChoice : public ::testing::Test {
  protected:
    BackEndChoice() {
        back_ends_.on_words([this](const std::string& words) { said_.push_back(words); });
    }
    BackEnds back_ends_{without_device};
    std::vector<std::string> said_;
};

TEST_F(BackEndChoice, IsTheProcessorAtFirst) {
    EXPECT_EQ(back_ends_.chosen(), "cpu");
    EXPECT_EQ(back_ends_.for_play().name, "cpu");
    EXPECT_TRUE(said_.empty());
    BackEnds without_a_program;
    EXPECT_EQ(without_a_program.for_play().name, "cpu");
    EXPECT_THROW(without_a_program.named("cuda"), InputError);
}

TEST_F(BackEndChoice, WithoutADeviceIsRefusedInWordsAndTheProcessorPlays) {
    back_ends_.choose("cuda");
    EXPECT_EQ(back_ends_.for_play().name, "cpu");
    ASSERT_EQ(said_.size(), 1u);
    EXPECT_NE(said_[0].find("there is none. Buy one"), std::string::npos) << said_[0];
    EXPECT_EQ(back_ends_.chosen(), "cuda") << "it stays the wish";
    EXPECT_EQ(back_ends_.for_play().name, "cpu");
    EXPECT_EQ(said_.size(), 1u) << "said once";
    back_ends_.choose("cuda");
    EXPECT_EQ(back_ends_.for_play().name, "cpu");
    EXPECT_EQ(said_.size(), 2u) << "once for each choice";
    EXPECT_THROW(back_ends_.named("cuda"), InputError) << "a recording needs that very one";
}

TEST_F(BackEndChoice, OfWhatThereIsSaysOnceThatItIsTheProcessor) {
    back_ends_.choose("auto");
    for (int plays = 0; plays < 3; ++plays) EXPECT_EQ(back_ends_.for_play().name, "cpu");
    EXPECT_EQ(said_, std::vector<std::string>{"The processor makes the steps: there is none"});
    back_ends_.on_words({});
    back_ends_.choose("auto");
    EXPECT_EQ(back_ends_.for_play().name, "cpu");
    EXPECT_EQ(said_.size(), 1u) << "nobody listens";
}

TEST(PatientLoader, SaysThatADialOfAnotherDeviceIsLeftOut) {
    const QTemporaryDir temporary;
    const auto folder = std::filesystem::path(temporary.path().toStdString()) / "a.hep";
    PatientCase patient = *small_patient();
    patient.dial_json = dial_json({{{}, 1.0, 0.2, "this body", "cuda", "NVIDIA X"}}, patient);
    write_case(folder, patient);
    Job job;
    OpenRequest request;
    request.reconstruct.ct = folder;
    const auto says_so = [](const LoadedPatient& loaded) {
        return std::ranges::any_of(loaded.warnings, [](const std::string& warning) {
            return warning.find("measured on NVIDIA X (cuda) are left out") != std::string::npos;
        });
    };
    EXPECT_TRUE(says_so(load_patient(request, job)));
    DeformBackEnd there = cpu_back_end();
    there.name = "cuda";
    there.device = "NVIDIA X";
    EXPECT_FALSE(says_so(load_patient(request, job, there)));
}

}  // namespace
}  // namespace hepatica
