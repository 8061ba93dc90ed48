// SPDX-License-Identifier: GPL-3.0-or-later
// What the cache's label says to the letter, how many stages each kind of patient takes, what
// kinds of files there are, and the body that a tree gets.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/base/sha256.h"
#include "core/image/volume_writer.h"
#include "core/opening/built_in_cache.h"
#include "core/opening/open_patient.h"
#include "core/opening/patient_image.h"
#include "core/reconstruction/built_in_patient.h"
#include "core/tree/files/tree_io.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

fs::path own_folder() {
    return fs::path(std::getenv("TEST_TMPDIR"));
}

std::string all_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string digest_of_text(const std::string& text) {
    Sha256 digest;
    digest.add_bytes(text.data(), text.size());
    return digest.hex_digest();
}

TEST(OpeningLimits, TheCachesLabelHoldsDigestsAndKey) {
    const BuiltInCache cache{own_folder() / "label", "program 7"};
    keep(cache, test::patient_with_bridges());
    const fs::path entry = cache.folder / "built_in_patient";
    const std::string below = digest_of_text("program 7\n" + built_in_parameters()) + '\n' +
                              sha256_of_file(entry / "patient.hep" / "case.json") + '\n';
    EXPECT_EQ(all_of(entry / "label.txt"), digest_of_text(below) + '\n' + below);
    EXPECT_TRUE(patient_of(cache));
    // There may be no line break in the end.
    const auto label_is = [&](const std::string& text) {
        std::ofstream(entry / "label.txt", std::ios::binary) << digest_of_text(text) + '\n' + text;
        return holds_patient(cache);
    };
    const std::string key = digest_of_text("program 7\n" + built_in_parameters());
    const std::string of_case = sha256_of_file(entry / "patient.hep" / "case.json");
    EXPECT_TRUE(label_is(key + '\n' + of_case));
    EXPECT_TRUE(patient_of(cache));
    EXPECT_FALSE(label_is(key + '\n' + of_case + "\nand more\n"));
    EXPECT_FALSE(label_is(key + '\n'));
    EXPECT_FALSE(label_is(key));
    EXPECT_FALSE(label_is(of_case + '\n' + of_case));
    EXPECT_TRUE(label_is(key + '\n' + key));
    EXPECT_FALSE(patient_of(cache)) << "of another case";
    std::ofstream(entry / "label.txt", std::ios::binary) << "";
    EXPECT_FALSE(holds_patient(cache));
    fs::remove_all(cache.folder);
}

TEST(OpeningLimits, EveryKindOfPatientTakesItsStages) {
    OpenRequest request;
    request.reconstruct.ct = "scan.nii.gz";
    EXPECT_EQ(opening_stage_count(request), stage_count(request.reconstruct));
    request.reconstruct.vessel_mask = "mask.nii.gz";
    EXPECT_EQ(opening_stage_count(request), stage_count(request.reconstruct));
    for (const char* tree : {"tree.vtp", "tree.swc", "tree.json"}) {
        request.reconstruct.ct = tree;
        EXPECT_EQ(opening_stage_count(request), 2) << tree;
    }
    request.built_in = true;
    EXPECT_EQ(opening_stage_count(request), built_in_stage_count());
    EXPECT_EQ(built_in_stage_count(), 15);
    const fs::path place = own_folder() / "stages.hep";
    write_case(place, test::patient_with_bridges());
    request.built_in = false;
    request.reconstruct.ct = place;
    EXPECT_EQ(opening_stage_count(request), 1);
    EXPECT_TRUE(is_case(place));
    fs::remove_all(place);
}

TEST(OpeningLimits, ATreeOfAnyFileGetsTheBodyOfTheOptionsAsTheyCome) {
    Job job;
    const TetMesh body = tetrahedralize(test::forked_tree(), MeshOptions{}, job);
    const fs::path file = own_folder() / "limits.json";
    write_tree_json(file, test::forked_tree());
    OpenRequest request;
    request.reconstruct.ct = file;
    Job opening;
    const OpenedPatient opened = open_patient(request, opening);
    EXPECT_EQ(opened.patient->mesh.tetrahedra, body.tetrahedra);
    EXPECT_EQ(opened.patient->surface.triangles, surface_of(body).mesh.triangles);
    EXPECT_EQ(opened.title, "limits.json");
    EXPECT_TRUE(opened.image.empty());
    EXPECT_TRUE(opened.warnings.empty() && opened.stages.empty());
    const std::vector<StageTime> stages = opening.stage_times();
    ASSERT_EQ(stages.size(), 2u);
    EXPECT_EQ(stages[0].name, "Reading the tree");
    EXPECT_EQ(stages[1].name, "Making the mesh");
    EXPECT_EQ(opening.progress().stage_count, 2);
    fs::remove(file);
}

TEST(OpeningLimits, PathsAreMadeAbsoluteWithoutAnEnd) {
    OpenRequest request;
    request.reconstruct.ct = "scan/";
    request.reconstruct.vessel_mask = "a/../vessels.nii";
    const OpenRequest absolute = with_absolute_paths(request);
    EXPECT_EQ(absolute.reconstruct.ct, fs::current_path() / "scan");
    EXPECT_TRUE(absolute.reconstruct.ct.has_filename());
    EXPECT_EQ(absolute.reconstruct.vessel_mask, fs::current_path() / "vessels.nii");
    EXPECT_FALSE(absolute.reconstruct.liver_mask);
}

// A scan becomes a patient that is worth to be saved; its stages and its image are told.
TEST(OpeningLimits, AScanIsReconstructedAndWorthSaving) {
    const fs::path folder = own_folder() / "limits scan";
    fs::create_directories(folder);
    Volume ct(Grid{{48, 48, 20}}, 100);
    ct.voxels[0] = 50;
    Mask line(ct.grid);
    for (std::size_t i = 0; i < line.voxels.size(); ++i) {
        const auto [x, y, z] = ct.grid.index_of(i);
        line.voxels[i] = std::hypot(x - 24.0, z - 10.0) < 3.0 && y > 4 && y < 44;
    }
    write_nifti(folder / "ct.nii.gz", ct);
    write_nifti(folder / "line.nii.gz", line);
    OpenRequest request;
    request.reconstruct.ct = folder / "ct.nii.gz";
    request.reconstruct.vessel_mask = folder / "line.nii.gz";
    request.reconstruct.mesh.target_tetrahedra = 500;
    Job job;
    const OpenedPatient opened = open_patient(request, job);
    EXPECT_TRUE(opened.worth_saving);
    EXPECT_EQ(opened.image, folder / "ct.nii.gz");
    EXPECT_EQ(opened.title, "ct.nii.gz");
    EXPECT_TRUE(opened.folder.empty());
    EXPECT_EQ(static_cast<int>(opened.stages.size()), opening_stage_count(request));
    EXPECT_EQ(opened.patient->tree.segments.size(), 1u);
    EXPECT_FALSE(OpenedPatient{}.worth_saving);
    EXPECT_FALSE(OpenRequest{}.built_in);
    fs::remove_all(folder);
}

// Two patients below one folder would else be called alike.
TEST(OpeningLimits, ASeriesOfSeveralIsCalledAfterTheFolderAtWhichTheyPart) {
    const auto in = [](const fs::path& folder) {
        SeriesDescription series;
        series.description = "series 5 \"Mrs. Miller\"";
        series.middle_slice = folder / "5.dcm";
        return series;
    };
    const std::vector<SeriesDescription> apart{in("/scan/all/case 1/DICOM"),
                                               in("/scan/all/case 7/DICOM")};
    EXPECT_EQ(title_of_series("/scan", apart, 1), "scan case 1");
    EXPECT_EQ(title_of_series("/scan/all", apart, 2), "all case 7");
    const std::vector<SeriesDescription> mixed{in("/scan"), in("/scan"), in("/scan/late")};
    EXPECT_EQ(title_of_series("/scan", mixed, 3), "scan late");
    EXPECT_EQ(title_of_series("/scan", mixed, 1), "scan 1");
    const std::vector<SeriesDescription> deep{in("/scan/7/SE1"), in("/scan/7/SE2"),
                                              in("/scan/8/SE1")};
    EXPECT_EQ(title_of_series("/scan", deep, 2), "scan 7 SE2");
    EXPECT_EQ(title_of_series("/scan", deep, 3), "scan 8");
    EXPECT_EQ(title_of_series("/scan", {mixed[2]}, 1), "scan") << "nothing was to be chosen";
    EXPECT_EQ(title_of_series("/scan", mixed, 4), "scan");
    EXPECT_EQ(title_of_series("/scan/case 7/DICOM", {mixed[2]}, 1), "case 7");
}

TEST(OpeningLimits, TheSeriesThatWasChosenGivesThePatientItsTitle) {
    const fs::path folder = own_folder() / "limits series";
    Volume ct(Grid{{48, 48, 20}}, 100);
    ct.voxels[0] = 50;
    Job job;
    for (const char* name : {"one", "two"}) {
        fs::create_directories(folder / name);
        ++ct.voxels[0];  // one with the same voxels would be the same series
        write_dicom_series(folder / name / "DICOM", ct, {}, job);
    }
    Mask line(ct.grid);
    for (std::size_t i = 0; i < line.voxels.size(); ++i) {
        const auto [x, y, z] = ct.grid.index_of(i);
        line.voxels[i] = std::hypot(x - 24.0, z - 10.0) < 3.0 && y > 4 && y < 44;
    }
    write_nifti(own_folder() / "series line.nii.gz", line);
    OpenRequest request;
    request.reconstruct.ct = folder;
    request.reconstruct.vessel_mask = own_folder() / "series line.nii.gz";
    request.reconstruct.mesh.target_tetrahedra = 500;
    request.reconstruct.series = 2;
    Job opening;
    const OpenedPatient opened = open_patient(request, opening);
    const std::string place =
        list_series(folder, job).at(1).middle_slice.parent_path().parent_path().filename();
    EXPECT_EQ(opened.title, "limits series " + place);
    EXPECT_EQ(static_cast<int>(opening.stage_times().size()), opening_stage_count(request));
    fs::remove_all(folder);
    fs::remove(own_folder() / "series line.nii.gz");
}

// Nobody asks for the phantom's CT where the grid tells already that it is another one.
TEST(OpeningLimits, ThePhantomIsMadeForItsOwnGridAlone) {
    PatientCase patient;
    patient.source.image_sha256 = "of no image";
    const auto stages_of = [&](const Index3& dims, const Vec3& spacing) {
        patient.source.image_grid.dims = dims;
        patient.source.image_grid.spacing_mm = spacing;
        Job job;
        job.cancel();
        try {
            image_of(patient, {}, job);
        } catch (const Cancelled&) {
            return true;
        } catch (const InputError& error) {
            EXPECT_EQ(error.remedy(), "choose its folder or file");
        }
        return false;
    };
    EXPECT_TRUE(stages_of({256, 256, 160}, Vec3(0.8, 0.8, 1.0)));
    EXPECT_TRUE(stages_of({256, 256, 160}, Vec3(0.8f, 0.8f, 1.0f)));
    EXPECT_FALSE(stages_of({256, 256, 161}, Vec3(0.8, 0.8, 1.0)));
    EXPECT_FALSE(stages_of({256, 256, 160}, Vec3(0.8, 0.8, 1.0001)));
}

// Where nobody wrote down which CT it was, any will do.
TEST(OpeningLimits, ACaseThatKnowsNoImageTakesAny) {
    const fs::path file = own_folder() / "any.nii.gz";
    const Volume ct(Grid{{16, 16, 8}}, 40);
    write_nifti(file, ct);
    Job job;
    EXPECT_EQ(image_of(PatientCase{}, file, job).voxels, ct.voxels);
    fs::remove(file);
}

}  // namespace
}  // namespace hepatica
