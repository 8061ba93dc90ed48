// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from CT to case on a small synthetic patient, watched through its job.
#include "core/patient/reconstruct.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>

#include "core/anatomy/phantom/phantom.h"
#include "core/base/error.h"
#include "core/image/volume_writer.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class SmallPatient : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        fs::create_directories(folder());
        PhantomOptions options;
        options.dims = {88, 88, 64};
        options.spacing_mm = Vec3(2.0, 2.0, 2.0);
        options.generations = 3;
        Job job;
        const Phantom phantom = make_phantom(options, job);
        write_nifti(folder() / "ct.nii.gz", phantom.ct);
        write_nifti(folder() / "liver.nii.gz", phantom.liver);
    }
    static void TearDownTestSuite() { fs::remove_all(folder()); }
    static fs::path folder() { return fs::path(testing::TempDir()) / "hepatica reconstruct"; }

    static ReconstructOptions options() {
        ReconstructOptions options;
        options.ct = folder() / "ct.nii.gz";
        options.liver_mask = folder() / "liver.nii.gz";
        options.mesh.target_tetrahedra = 1500;
        return options;
    }
};

// How often a stage looked at its job, and where in the order of all looks it began.
struct Looks {
    int first = 0;
    int count = 0;
};

std::map<int, Looks> looks_of_stages(const ReconstructOptions& options) {
    std::map<int, Looks> stages;
    Job job;
    std::mutex mutex;
    int looks = 0;
    job.observe([&](JobEvent) {
        const int number = job.progress().stage_number;
        const std::scoped_lock lock(mutex);
        Looks& stage = stages.try_emplace(number, Looks{looks, 0}).first->second;
        ++stage.count;
        ++looks;
    });
    reconstruct(options, job);
    stages.erase(0);
    return stages;
}

TEST_F(SmallPatient, StopsAtTheNextLook) {
    for (const auto& [number, looks] : looks_of_stages(options())) {
        if (number % 3 != 2) continue;  // each try goes through all stages before
        Job job;
        std::atomic<int> seen{0}, after{0};
        job.observe([&](JobEvent) {
            if (job.cancelled()) ++after;
            if (++seen == looks.first + looks.count / 2 + 1) job.cancel();
        });
        EXPECT_THROW(reconstruct(options(), job), Cancelled) << "stage " << number;
        // Each thread that still worked notices once, and nobody goes on.
        EXPECT_LE(after, 64) << "stage " << number;
    }
}

// What a second of work is differs from machine to machine; that no stage is one silent block does
// not. `hepatica-cli bench reconstruct` measures the seconds.
TEST_F(SmallPatient, EveryStageLooksAtItsJobManyTimes) {
    const auto stages = looks_of_stages(options());
    EXPECT_GE(stages.size(), 9u);
    int many = 0;
    for (const auto& [number, looks] : stages) {
        EXPECT_GE(looks.count, 4) << "stage " << number;
        many += looks.count >= 100 ? 1 : 0;
    }
    EXPECT_GE(many, 5);  // those that take long on a real patient
}

}  // namespace
}  // namespace hepatica
