// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from CT to case on a small synthetic patient, watched through its job.
#include "core/reconstruction/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/support/falls_of_progress.h"

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

// Filters, fronts and searches report each from 0 to 1: of a stage they are parts.
TEST_F(SmallPatient, TheProgressOfNoStageFallsBack) {
    ReconstructOptions smoothed = options();
    smoothed.refinement_recursions = 2;
    Job job;
    const test::FallsOfProgress falls(job);
    reconstruct(smoothed, job);
    std::string named;
    for (const std::string& stage : falls.stages()) named += stage + "; ";
    EXPECT_EQ(named, "");
}

bool says(const Reconstruction& made, const std::string& words) {
    return std::ranges::any_of(made.warnings, [&](const std::string& warning) {
        return warning.find(words) != std::string::npos;
    });
}

// A ring with two stems, as two veins make that were drawn as one mask where they touch.
TEST(Reconstruct, OpensALoopWithinOneSystemAndSaysSo) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica loops";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {64, 64, 24};
    Volume ct(grid, 100);
    ct.voxels[0] = 50;
    Mask ring(grid), line(grid);
    for (std::size_t i = 0; i < ring.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const double from_axis = std::hypot(x - 32.0, y - 32.0);
        const bool stem = std::hypot(x - 32.0, z - 12.0) < 3.0 && y > 4 && y < 60;
        ring.voxels[i] =
            std::hypot(from_axis - 16.0, z - 12.0) < 3.0 || (stem && std::abs(y - 32.0) > 14.0);
        line.voxels[i] = stem;
    }
    write_nifti(folder / "ct.nii.gz", ct);
    write_nifti(folder / "ring.nii.gz", ring);
    write_nifti(folder / "line.nii.gz", line);
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.mesh.target_tetrahedra = 1500;
    Job job;
    options.vessel_mask = folder / "ring.nii.gz";
    const Reconstruction opened = reconstruct(options, job);
    EXPECT_TRUE(says(opened, "1 loop within one system"));
    EXPECT_EQ(opened.patient.doubts->opened_loops, 1);
    EXPECT_EQ(opened.patient.doubts->loops, 0);
    for (const VesselSegment& segment : opened.patient.tree.segments)
        EXPECT_FALSE(segment.closes_loop);
    options.vessel_mask = folder / "line.nii.gz";
    EXPECT_FALSE(says(reconstruct(options, job), "loop"));
    fs::remove_all(folder);
}

// Whoever gives a wrong file need not wait until the vessels are found.
TEST_F(SmallPatient, AMaskOfTumoursThatDoesNotFitIsRefusedBeforeTheLongWork) {
    Mask other{Grid{{20, 20, 20}}};
    other.voxels[0] = 1;
    other.grid.origin_mm = Vec3(5000, 0, 0);
    write_nifti(folder() / "other.nii.gz", other);
    ReconstructOptions wrong = options();
    wrong.tumour_masks = {folder() / "other.nii.gz"};
    Job job;
    try {
        reconstruct(wrong, job);
        FAIL() << "it lies five metres away";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), (folder() / "other.nii.gz").string());
    }
    EXPECT_EQ(job.progress().stage_number, 2) << job.progress().stage;
}

// A seed beside every vessel says nothing; it must not name the vessel that happens to be nearest.
TEST(Reconstruct, ASeedInNoVesselIsRefusedByItsPlace) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica seed";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {64, 64, 24};
    Volume ct(grid, 100);
    ct.voxels[0] = 50;
    Mask line(grid);
    for (std::size_t i = 0; i < line.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        line.voxels[i] = std::hypot(x - 32.0, z - 12.0) < 3.0 && y > 4 && y < 60;
    }
    write_nifti(folder / "ct.nii.gz", ct);
    write_nifti(folder / "line.nii.gz", line);
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.vessel_mask = folder / "line.nii.gz";
    options.seeds = {{Vec3(10, 30, 12), VascularSystem::portal}};
    Job job;
    try {
        reconstruct(options, job);
        FAIL() << "the seed was taken";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("no vessel lies within 3 mm of the seed at 10"),
                  std::string::npos)
            << error.problem();
    }
    fs::remove_all(folder);
}

// The steps that look for liver and vessels know no file; of several patients one must be named.
TEST(Reconstruct, NamesTheCtThatShowsNoVessels) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica plain";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {64, 64, 24};
    Volume ct(grid, 100);
    ct.voxels[0] = 50;
    ReconstructOptions options;
    options.ct = folder / "plain.nii.gz";
    write_nifti(options.ct, ct);
    Job job;
    try {
        reconstruct(options, job);
        FAIL() << "a plain block was taken for a liver with vessels";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), options.ct.string()) << error.what();
    }
    fs::remove_all(folder);
}

// Another mask helps here, not the mask that was given already.
TEST(Reconstruct, NamesTheMaskWhoseVesselsMakeNoTree) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica speck";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {24, 24, 24};
    Volume ct(grid, 100);
    ct.voxels[0] = 50;
    Mask speck(grid);
    speck.at(12, 12, 12) = 1;
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.vessel_mask = folder / "speck.nii.gz";
    write_nifti(options.ct, ct);
    write_nifti(*options.vessel_mask, speck);
    Job job;
    try {
        reconstruct(options, job);
        FAIL() << "a voxel made a tree";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), options.vessel_mask->string()) << error.what();
        EXPECT_EQ(error.remedy(), "Choose a mask that holds whole vessels");
    }
    fs::remove_all(folder);
}

TEST(Reconstruct, ACancelledJobThrowsBeforeAnythingIsRead) {
    Job job;
    job.cancel();
    ReconstructOptions options;
    options.ct = "nowhere";
    EXPECT_THROW(reconstruct(options, job), Cancelled);
}

TEST(Reconstruct, NamesTheImageThatIsNotThere) {
    Job job;
    ReconstructOptions options;
    options.ct = "nowhere";
    try {
        reconstruct(options, job);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("nowhere"), std::string::npos);
    }
}

}  // namespace
}  // namespace hepatica
