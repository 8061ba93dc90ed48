// SPDX-License-Identifier: GPL-3.0-or-later
// A case as a DICOM segmentation of its CT, and for 3D Slicer, through the real program.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/atomic_write.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::run_cli;

class Export : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        fs::remove_all(folder());
        fs::create_directories(folder());
        for (const char* seed : {"1", "2"})
            answer({"phantom", (folder() / seed).string(), "--seed", seed, "--dims", "88,88,64",
                    "--spacing", "2,2,2", "--generations", "3"});
        answer({"reconstruct", ct().string(), "--liver-mask",
                (folder() / "1/liver.nii.gz").string(), "--out", made().string(), "--tetrahedra",
                "1500", "--spacing-mm", "1"});  // voxels of 2 mm hold no more
    }
    static void TearDownTestSuite() { fs::remove_all(folder()); }
    static fs::path folder() { return fs::path(testing::TempDir()) / "export verb"; }
    static fs::path ct() { return folder() / "1" / "ct"; }
    static fs::path made() { return folder() / "p.hep"; }
};

TEST_F(Export, WritesTheCasesVesselsAndItsLiver) {
    const fs::path out = folder() / "vessels.dcm";
    answer({"export", made().string(), "--ct", ct().string(), "--out", out.string()});
    const PatientCase patient = read_case(made());
    Job job;
    const Volume image = read_volume(ct(), job);
    const auto volume_mm3 = [](const Mask& mask, auto&& counts) {
        std::size_t voxels = 0;
        for (const std::uint8_t label : mask.voxels) voxels += counts(label) ? 1 : 0;
        return static_cast<double>(voxels) * mask.grid.spacing_mm.prod();
    };
    // This phantom has one system, and the liver is the last of the organs that are known.
    const std::vector<int> vessels{1}, liver{2};
    const Mask vessel = on_grid_of(image.grid, read_mask(out, job, vessels), "out");
    const Mask organ = on_grid_of(image.grid, read_mask(out, job, liver), "out");
    const auto any = [](std::uint8_t label) { return label != 0; };
    const auto of_liver = [](std::uint8_t label) { return label == organ_label::liver; };
    EXPECT_NEAR(volume_mm3(vessel, any) / volume_mm3(patient.mask, any), 1.0, 0.05);
    EXPECT_NEAR(volume_mm3(organ, any) / volume_mm3(patient.organs, of_liver), 1.0, 0.01);
    // Written again over itself it is replaced.
    answer({"export", made().string(), "--ct", ct().string(), "--out", out.string()});
}

TEST_F(Export, RefusesAnotherCtAndAFileThatIsNoSegmentation) {
    const fs::path out = folder() / "of another.dcm";
    const auto other = run_cli(
        {"export", made().string(), "--ct", (folder() / "2/ct").string(), "--out", out.string()});
    EXPECT_NE(other.exit_code, 0);
    EXPECT_NE(other.errors.find("is not the CT that the patient was reconstructed from"),
              std::string::npos)
        << other.errors;
    EXPECT_FALSE(fs::exists(out));
    const fs::path slice = ct() / "slice_0001.dcm";
    const auto size = fs::file_size(slice);
    const auto over =
        run_cli({"export", made().string(), "--ct", ct().string(), "--out", slice.string()});
    EXPECT_NE(over.exit_code, 0);
    EXPECT_NE(over.errors.find("is there and is no segmentation"), std::string::npos)
        << over.errors;
    EXPECT_EQ(fs::file_size(slice), size);
}

TEST_F(Export, ForSlicerNeedsNoCt) {
    const fs::path out = folder() / "vessels.seg.nrrd";
    answer({"export", made().string(), "--out", out.string()});
    const PatientCase patient = read_case(made());
    Job job;
    const LabelMap labels = read_label_map(out, job);
    EXPECT_TRUE(same_grid(labels.grid, read_volume(ct(), job).grid));
    // This phantom has one system; the liver is what is left of it beside the vessels.
    std::size_t vessels = 0;
    for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
        const auto [x, y, z] = labels.grid.index_of(i);
        const Vec3 p = patient.source.image_grid.to_mm(x, y, z);
        const bool vessel = value_at(patient.mask, p) != 0;
        const bool liver = value_at(patient.organs, p) == organ_label::liver;
        ASSERT_EQ(labels.voxels[i], vessel ? 1 : (liver ? 2 : 0)) << p.transpose();
        vessels += vessel;
    }
    EXPECT_GT(vessels, 100u);
}

TEST_F(Export, SaysWhichNameGoesWithWhat) {
    const auto refused = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"export", made().string()});
        const auto run = run_cli(options);
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        return run.errors;
    };
    const auto in_folder = [](const char* name) { return (folder() / name).string(); };
    EXPECT_NE(refused({"--out", in_folder("v.dcm")}).find("--ct: is missing"), std::string::npos);
    EXPECT_NE(
        refused({"--out", in_folder("v.seg.nrrd"), "--ct", ct().string()}).find("is not used"),
        std::string::npos);
    EXPECT_NE(refused({"--out", in_folder("v.nrrd"), "--ct", ct().string()})
                  .find("does not end in .seg.nrrd"),
              std::string::npos);
    for (const char* name : {"v.png", "v.nii.gz", "v.seg"}) {
        const std::string said = refused({"--out", in_folder(name), "--ct", ct().string()});
        EXPECT_NE(said.find("ends in .dcm or .seg.nrrd"), std::string::npos) << said;
        EXPECT_FALSE(fs::exists(in_folder(name))) << name;
    }
    for (const char* name : {"v.dcm", "v.seg.nrrd", "v.nrrd"})
        EXPECT_FALSE(fs::exists(in_folder(name))) << name;
}

}  // namespace
}  // namespace hepatica
