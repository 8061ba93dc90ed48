// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic patient whose voxels are painted and erased.
#include "core/reconstruction/remade_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/base/error.h"
#include "core/image/brush.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/patient/corrections.h"
#include "core/patient/painted_tumours.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/reconstruct.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/tree/station.h"
#include "tests/reconstruction/real_case.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

Phantom phantom_of_two_systems(Job& job) {
    PhantomOptions options;
    options.dims = {88, 88, 64};
    options.spacing_mm = Vec3(2.0, 2.0, 2.0);
    options.generations = 3;
    options.systems = 2;
    return make_phantom(options, job);
}

class RemadeCaseTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        Job job;
        const Phantom phantom = phantom_of_two_systems(job);
        const fs::path folder = fs::path(testing::TempDir()) / "remade case";
        fs::create_directories(folder);
        write_nifti(folder / "ct.nii.gz", phantom.ct);
        write_nifti(folder / "liver.nii.gz", phantom.liver);
        ReconstructOptions reconstruction;
        reconstruction.ct = folder / "ct.nii.gz";
        reconstruction.liver_mask = folder / "liver.nii.gz";
        reconstruction.spacing_mm = 1.0;  // voxels of 2 mm hold no more
        reconstruction.mesh.target_tetrahedra = 1500;
        patient_ = new PatientCase(reconstruct(reconstruction, job).patient);
        ct_ = new Volume(read_volume(reconstruction.ct, job));
        fs::remove_all(folder);
    }
    static void TearDownTestSuite() {
        delete std::exchange(patient_, nullptr);
        delete std::exchange(ct_, nullptr);
    }
    static RemadeCase remade_of(const Mask& mask, const PatientCase& patient = *patient_) {
        Job job;
        job.expect_stages(remade_stages);
        RemadeCase made = remade(patient, mask, *ct_, job);
        EXPECT_EQ(job.progress().stage_number, remade_stages);
        return made;
    }
    // The middle of an end branch of 10 mm or more.
    static Station twig() {
        const auto below = children(patient_->tree);
        for (std::size_t s = 0; s < below.size(); ++s)
            if (const auto& segment = patient_->tree.segments[s];
                below[s].empty() && length_mm(segment) > 10.0)
                return station_at(segment, 0.6 * length_mm(segment));
        throw std::runtime_error("there is no long twig");
    }

    static inline PatientCase* patient_ = nullptr;
    static inline Volume* ct_ = nullptr;
};

bool same_points(const VesselTree& a, const VesselTree& b) {
    return std::ranges::equal(a.segments, b.segments, [](const auto& x, const auto& y) {
        return x.points_mm == y.points_mm && x.radii_mm == y.radii_mm && x.system == y.system &&
               x.parent == y.parent;
    });
}

TEST_F(RemadeCaseTest, OfItsOwnVoxelsIsTheSameToTheBit) {
    const RemadeCase made = remade_of(patient_->mask);
    EXPECT_TRUE(same_points(made.patient.tree, patient_->tree));
    EXPECT_EQ(made.patient.mask.voxels, patient_->mask.voxels);
    EXPECT_EQ(made.patient.skeleton.voxels, patient_->skeleton.voxels);
    EXPECT_EQ(made.patient.couinaud.voxels, patient_->couinaud.voxels);
    EXPECT_EQ(hash_of(made.patient), hash_of(*patient_)) << "the body, too";
    EXPECT_EQ(made.patient.doubts->contrast_hu, patient_->doubts->contrast_hu);
    EXPECT_EQ(made.patient.source.image_sha256, patient_->source.image_sha256);
}

// Who has refused a gap is not asked about it again because something was painted elsewhere.
TEST_F(RemadeCaseTest, AGapThatWasRefusedStaysRefused) {
    ReconstructOptions careful;
    careful.spacing_mm = 1.0;
    careful.mesh.target_tetrahedra = 1500;
    careful.bridge_confidence = 1.0;  // all gaps are only offered
    PatientCase parted = *patient_;
    parted.source.parameters_json = parameters_json(careful);
    const auto longest = std::ranges::max_element(
        parted.tree.segments, {}, [](const VesselSegment& one) { return length_mm(one); });
    const Station middle = station_at(*longest, 0.5 * length_mm(*longest));
    BrushStroke stroke;
    stroke.radius_mm = middle.radius_mm + 2.0;
    stroke.path_mm = {middle.position_mm};
    apply(stroke, 0, parted.mask);
    PatientCase asked = remade_of(parted.mask, parted).patient;
    const auto open = open_bridges(asked);
    ASSERT_FALSE(open.empty());
    std::vector<TreeEdit> refusals;
    for (const Bridge& bridge : open) refusals.push_back(refusal_of(bridge));
    asked = with_edited_tree(asked, refusals);
    const PatientCase again = remade_of(asked.mask, asked).patient;
    ASSERT_EQ(again.corrections.bridges.size(), asked.corrections.bridges.size());
    EXPECT_TRUE(open_bridges(again).empty());
}

// Systems are found in a mask of one number and kept in one of several: when it is remade as well.
TEST(FromVoxelsOptions, OfAGivenMaskFindSystemsWhereTheReconstructionDid) {
    Job job;
    const Phantom phantom = phantom_of_two_systems(job);
    const fs::path folder = fs::path(testing::TempDir()) / "remade of a given mask";
    fs::create_directories(folder);
    ReconstructOptions reconstruction;
    reconstruction.ct = folder / "ct.nii.gz";
    reconstruction.vessel_mask = folder / "vessels.nii.gz";
    reconstruction.mesh.target_tetrahedra = 1500;
    write_nifti(reconstruction.ct, phantom.ct);
    for (const bool has_systems : {true, false}) {
        Mask vessels = phantom.vessels;
        for (std::uint8_t& voxel : vessels.voxels)
            if (!has_systems && voxel != 0) voxel = 1;
        write_nifti(*reconstruction.vessel_mask, vessels);
        const PatientCase patient = reconstruct(reconstruction, job).patient;
        EXPECT_EQ(from_voxels_options(patient.source.parameters_json).find_systems, !has_systems);
    }
    fs::remove_all(folder);
}

// The patient's own voxels say what his vessels were; numbers in those that are given do not.
TEST_F(RemadeCaseTest, AVesselStaysWhatThePatientHadIt) {
    Mask exchanged = patient_->mask;
    for (std::uint8_t& voxel : exchanged.voxels)
        if (voxel == 1 || voxel == 2) voxel = static_cast<std::uint8_t>(3 - voxel);
    EXPECT_TRUE(same_points(remade_of(exchanged).patient.tree, patient_->tree));

    PatientCase called_other = *patient_;
    for (std::uint8_t& voxel : called_other.mask.voxels)
        if (voxel == 1) voxel = 2;
    const auto portal_mm = [](const VesselTree& tree) {
        double sum_mm = 0.0;
        for (const VesselSegment& segment : tree.segments)
            if (segment.system == VascularSystem::portal) sum_mm += length_mm(segment);
        return sum_mm;
    };
    EXPECT_LT(portal_mm(remade_of(patient_->mask, called_other).patient.tree),
              0.5 * portal_mm(patient_->tree));
}

// A twig is rubbed out, and comes back when it is painted.
TEST_F(RemadeCaseTest, WhatIsErasedGoesAndWhatIsPaintedComes) {
    const Station at = twig();
    Mask mask = patient_->mask;
    const auto& segment = patient_->tree.segments[static_cast<std::size_t>(
        nearest_point(patient_->tree, at.position_mm).segment)];
    BrushStroke stroke;
    stroke.radius_mm = 2.0 * at.radius_mm + 1.0;
    for (double along = 0.4 * length_mm(segment); along <= length_mm(segment); along += 1.0)
        stroke.path_mm.push_back(station_at(segment, along).position_mm);
    stroke.erases = true;
    apply(stroke, 0, mask);
    const PatientCase erased = remade_of(mask).patient;
    EXPECT_LT(length_mm(erased.tree), length_mm(patient_->tree) - 3.0);
    EXPECT_GT(nearest_point(erased.tree, at.position_mm).distance_mm, at.radius_mm);
    stroke.erases = false;
    stroke.radius_mm = at.radius_mm;
    apply(stroke, static_cast<std::uint8_t>(number_of(VascularSystem::unknown)), mask);
    const PatientCase painted = remade_of(mask, erased).patient;
    const TreePoint found = nearest_point(painted.tree, at.position_mm);
    EXPECT_LT(found.distance_mm, 0.7);
    EXPECT_EQ(painted.tree.segments[static_cast<std::size_t>(found.segment)].system,
              segment.system);
    for (const Vec3& place : stroke.path_mm)
        EXPECT_LT(nearest_point(painted.tree, place).distance_mm, 1.0) << place.transpose();
}

// Systems that were given are not found anew, so painting over a vessel has to leave it its own.
TEST_F(RemadeCaseTest, WhatIsPaintedOverAVesselStaysOfItsSystem) {
    ReconstructOptions drawn;
    drawn.vessel_mask = "vessels.nii.gz";
    PatientCase given = *patient_;
    given.source.parameters_json = parameters_json(drawn);
    const Station at = twig();
    const auto system_at = [&](const VesselTree& tree) {
        return tree.segments[static_cast<std::size_t>(nearest_point(tree, at.position_mm).segment)]
            .system;
    };
    ASSERT_NE(system_at(given.tree), VascularSystem::unknown);
    BrushStroke stroke;  // over the whole twig
    stroke.radius_mm = at.radius_mm;
    stroke.path_mm =
        given.tree
            .segments[static_cast<std::size_t>(nearest_point(given.tree, at.position_mm).segment)]
            .points_mm;
    Mask painted = given.mask;
    apply(stroke, painted_voxel, painted);
    EXPECT_EQ(system_at(remade_of(painted, given).patient.tree), system_at(given.tree));
}

// A short piece far from all others, and a fat one: without a person's hand both are left out.
TEST_F(RemadeCaseTest, WhatIsPaintedIsKeptAsIfASeedLayInIt) {
    // Within the grid, and away from the vessels.
    const Grid& grid = patient_->mask.grid;
    Vec3 place = Vec3::Zero();
    double farthest = 0.0;
    for (std::size_t i = 0; i < patient_->mask.voxels.size(); i += 97) {
        const Index3 at = grid.index_of(i);
        if ((Eigen::Array3i(at[0], at[1], at[2]) < 14).any() ||
            (Eigen::Array3i(grid.dims[0] - at[0], grid.dims[1] - at[1], grid.dims[2] - at[2]) < 14)
                .any())
            continue;
        const Vec3 here = grid.to_mm(at[0], at[1], at[2]);
        const double away = nearest_point(patient_->tree, here).distance_mm;
        if (away > farthest) {
            farthest = away;
            place = here;
        }
    }
    ASSERT_GT(farthest, 12.0);
    for (const double radius_mm : {1.5, 4.5}) {
        BrushStroke stroke;
        stroke.radius_mm = radius_mm;
        for (double along = -5.0; along <= 5.0; along += 0.5)
            stroke.path_mm.push_back(place + Vec3(along, 0, 0));
        Mask drawn = patient_->mask, painted = patient_->mask;
        apply(stroke, static_cast<std::uint8_t>(number_of(VascularSystem::unknown)), drawn);
        apply(stroke, painted_voxel, painted);
        EXPECT_GT(nearest_point(remade_of(drawn).patient.tree, place).distance_mm, 8.0)
            << "nobody says that it is a vessel";
        const RemadeCase made = remade_of(painted);
        EXPECT_LT(nearest_point(made.patient.tree, place).distance_mm, 2.0) << radius_mm;
        EXPECT_EQ(std::ranges::count(made.patient.mask.voxels, painted_voxel), 0);
    }
    // A dab of one voxel has no centreline: then it is said which one it was.
    BrushStroke dab{{place}, 0.6, false};
    Mask painted = patient_->mask;
    apply(dab, painted_voxel, painted);
    const RemadeCase made = remade_of(painted);
    EXPECT_TRUE(std::ranges::any_of(made.warnings,
                                    [&](const std::string& warning) {
                                        return warning.starts_with("What was painted at ") &&
                                               warning.find("left out of the tree") !=
                                                   std::string::npos;
                                    }))
        << "painted at " << place.transpose();
}

// Voxels that no tree claims are of no system, whatever they were called before.
TEST_F(RemadeCaseTest, SystemsFromBeforeAreForgotten) {
    Mask mask = patient_->mask;
    Vec3 apart = Vec3::Zero();
    double farthest_mm = 0.0;
    for (std::size_t i = 0; i < patient_->organs.voxels.size(); i += 97) {
        const auto [x, y, z] = patient_->organs.grid.index_of(i);
        const Vec3 place = patient_->organs.grid.to_mm(x, y, z);
        const double away_mm = nearest_point(patient_->tree, place).distance_mm;
        if (patient_->organs.voxels[i] == 0 || away_mm <= farthest_mm) continue;
        farthest_mm = away_mm;
        apart = place;
    }
    const Vec3 index = mask.grid.to_index(apart).array().round();
    const std::size_t there = mask.grid.offset(
        static_cast<int>(index.x()), static_cast<int>(index.y()), static_cast<int>(index.z()));
    apply({{apart}, 1.5, false}, static_cast<std::uint8_t>(number_of(VascularSystem::portal)),
          mask);
    ASSERT_EQ(mask.voxels[there], number_of(VascularSystem::portal));
    const PatientCase made = remade_of(mask).patient;
    EXPECT_EQ(made.mask.voxels[there], number_of(VascularSystem::unknown));
}

// A case that keeps where its trunk was seen begins shortly before that divides, however often it
// is remade; one of an older program, whose root alone is known, stays as long as it was.
TEST_F(RemadeCaseTest, TheTrunkIsShortenedOnceAndWhereItWasSeen) {
    const auto portal_root = [](const VesselTree& tree) {
        for (const VesselSegment& segment : tree.segments)
            if (segment.parent < 0 && segment.system == VascularSystem::portal)
                return segment.points_mm.front();
        throw std::runtime_error("there is no portal vein");
    };
    const Vec3 seen_mm = portal_root(patient_->tree);
    PatientCase keeps = *patient_;
    keep_portal_trunk(seen_mm, keeps.source.parameters_json);
    const PatientCase once = remade_of(patient_->mask, keeps).patient;
    EXPECT_LT(length_mm(once.tree), length_mm(patient_->tree) - 3.0);
    EXPECT_GT((portal_root(once.tree) - seen_mm).norm(), 3.0);
    EXPECT_LT(nearest_point(patient_->tree, portal_root(once.tree)).distance_mm, 0.5);
    EXPECT_EQ(once.source.parameters_json, keeps.source.parameters_json);
    const PatientCase twice = remade_of(once.mask, once).patient;
    EXPECT_TRUE(same_points(twice.tree, once.tree));
    EXPECT_EQ(hash_of(twice), hash_of(once));
    EXPECT_EQ(portal_root(remade_of(patient_->mask).patient.tree), seen_mm);
}

// The portal trunk comes in where it did.
class RemadeRealCase : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ircadb01, RemadeRealCase, testing::ValuesIn(test::real_cases));

TEST_P(RemadeRealCase, OfItsOwnVoxelsIsTheSameToTheBit) {
    const fs::path folder = test::shared_data() / GetParam();
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const ReconstructOptions options = test::quick_options(folder);
    Job job;
    const PatientCase patient = reconstruct(options, job).patient;
    const Volume ct = read_volume(options.ct, job);
    const PatientCase again = remade(patient, patient.mask, ct, job).patient;
    EXPECT_TRUE(same_points(again.tree, patient.tree));
    EXPECT_EQ(hash_of(again), hash_of(patient));
}

TEST_F(RemadeCaseTest, EditsAreMadeAgainAndThoseThatCannotBeAreNamed) {
    const Station at = twig();
    TreeEdit cut, elsewhere;
    cut.kind = TreeEditKind::cut_link;
    cut.at_mm = at.position_mm;
    elsewhere.kind = TreeEditKind::set_root;
    elsewhere.at_mm = patient_->tree.segments[0].points_mm.front();
    Job job;
    const PatientCase edited = with_edits(*patient_, {cut, elsewhere}, job);
    const RemadeCase again = remade_of(patient_->mask, edited);
    EXPECT_EQ(again.patient.corrections.edits, edited.corrections.edits);
    EXPECT_EQ(hash_of(again.patient), hash_of(edited));
    Mask mask = patient_->mask;
    apply({{at.position_mm}, 14.0, true}, 0, mask);
    const RemadeCase without = remade_of(mask, edited);
    ASSERT_EQ(without.patient.corrections.edits.size(), 1u);
    EXPECT_EQ(without.patient.corrections.edits[0], elsewhere);
    EXPECT_TRUE(std::ranges::any_of(without.warnings, [](const std::string& warning) {
        return warning.starts_with("The correction number 1 is left out");
    }));
}

// Each edit repeats all before it: a long list takes longer than anybody waits for a cancellation.
TEST_F(RemadeCaseTest, AsksBeforeEachEditThatIsMadeAgain) {
    const auto checks_with = [](std::size_t edits) {
        PatientCase edited = *patient_;
        TreeEdit nowhere;  // made on no vessel, so that the rest is the same
        nowhere.at_mm = Vec3(5000, 0, 0);
        edited.corrections.extracted = edited.tree;
        edited.corrections.edits.assign(edits, nowhere);
        std::atomic<std::size_t> checks = 0;
        Job job;
        job.observe([&](JobEvent event) { checks += event == JobEvent::check; });
        const RemadeCase made = remade(edited, patient_->mask, *ct_, job);
        EXPECT_TRUE(made.patient.corrections.edits.empty());
        return checks.load();
    };
    const std::size_t without = checks_with(0);
    EXPECT_EQ(checks_with(9), without + 9);
}

// Also where it sticks out of the liver, whose box tells anatomy where to look.
TEST_F(RemadeCaseTest, TumoursThatWerePaintedStayAndChangeNoVessel) {
    const Grid& grid = patient_->organs.grid;
    const Vec3 border = grid.to_mm(0, grid.dims[1] / 2, grid.dims[2] / 2);
    PatientCase patient = *patient_;
    set_tumour_strokes(patient, {tumour_edit({{border}, 12.0, false}, 1)});
    ASSERT_FALSE(tumours_in(patient.organs).empty());
    const PatientCase made = remade_of(patient.mask, patient).patient;
    EXPECT_EQ(made.organs.voxels, patient.organs.voxels);
    EXPECT_EQ(made.corrections.edits, patient.corrections.edits);
    EXPECT_TRUE(same_points(made.tree, remade_of(patient_->mask).patient.tree));
    PatientCase back = made;
    set_tumour_strokes(back, {});
    EXPECT_EQ(back.organs.voxels, patient_->organs.voxels);
}

TEST_F(RemadeCaseTest, KeepsWhatWasWarnedOfTheImageAndNoOldWarningOfVessels) {
    ASSERT_EQ(patient_->warnings_of_image, 1u);
    const std::string of_image = patient_->warnings[0];
    EXPECT_TRUE(of_image.starts_with("The slices are 2.0 mm apart")) << of_image;
    PatientCase warned = *patient_;
    warned.warnings.emplace_back("of the old vessels");
    const PatientCase made = remade_of(patient_->mask, warned).patient;
    EXPECT_EQ(made.warnings_of_image, 1u);
    EXPECT_EQ(made.warnings.at(0), of_image);
    EXPECT_EQ(std::ranges::count(made.warnings, "of the old vessels"), 0);
    EXPECT_EQ(std::ranges::count(made.warnings, of_image), 1);
}

// Its neighbour must not be taken for the vessel that a person named.
TEST_F(RemadeCaseTest, ASeedWhoseVesselIsErasedIsLeftOut) {
    const Station at = twig();
    PatientCase seeded = *patient_;
    ReconstructOptions options;
    options.mesh.target_tetrahedra = 1500;
    options.seeds = {{at.position_mm, VascularSystem::artery}};
    seeded.source.parameters_json = parameters_json(options);
    const auto is_artery = [](const VesselSegment& segment) {
        return segment.system == VascularSystem::artery;
    };
    const RemadeCase there = remade_of(patient_->mask, seeded);
    EXPECT_TRUE(std::ranges::any_of(there.patient.tree.segments, is_artery));
    Mask mask = patient_->mask;
    apply({{at.position_mm}, at.radius_mm + 6.0, true}, 0, mask);
    const RemadeCase gone = remade_of(mask, seeded);
    EXPECT_FALSE(std::ranges::any_of(gone.patient.tree.segments, is_artery));
    EXPECT_TRUE(std::ranges::any_of(gone.warnings, [](const std::string& warning) {
        return warning.starts_with("The seed at ");
    }));
}

TEST(FromVoxelsOptions, AreThoseOfTheReconstruction) {
    ReconstructOptions made;
    EXPECT_TRUE(from_voxels_options(parameters_json(made)).find_systems);
    EXPECT_EQ(from_voxels_options(parameters_json(made)).bridge_confidence, 0.25);
    made.bridge_confidence = 0.75;
    made.thinning = ThinningMethod::parallel;
    made.vessel_mask = "vessels.nii.gz";
    FromVoxelsOptions options = from_voxels_options(parameters_json(made));
    EXPECT_EQ(options.bridge_confidence, 0.75);
    EXPECT_EQ(options.thinning, ThinningMethod::parallel);
    EXPECT_FALSE(options.find_systems) << "somebody drew them";
    made.seeds = {{Vec3(1.5, -2, 3), VascularSystem::hepatic}};
    options = from_voxels_options(parameters_json(made));
    EXPECT_TRUE(options.find_systems);
    ASSERT_EQ(options.seeds.size(), 1u);
    EXPECT_EQ(options.seeds[0].position_mm, Vec3(1.5, -2, 3));
    EXPECT_EQ(options.seeds[0].system, VascularSystem::hepatic);
    EXPECT_FALSE(options.portal_trunk_mm);
    EXPECT_FALSE(options.shorten_trunk) << "an older case, or one whose trunk was not seen";
    // Odd numbers come back to the bit.
    const Vec3 seen_mm(0.1, -1.0 / 3.0, 30.0);
    std::string kept = parameters_json(made);
    keep_portal_trunk(std::nullopt, kept);
    EXPECT_EQ(kept, parameters_json(made));
    keep_portal_trunk(seen_mm, kept);
    EXPECT_EQ(from_voxels_options(kept).portal_trunk_mm, seen_mm);
    EXPECT_TRUE(from_voxels_options(kept).shorten_trunk);
    EXPECT_EQ(from_voxels_options(kept).seeds.size(), 1u);
    // What a file may hold instead.
    for (const char* text : {"", "[]", "{\"seeds\": 3, \"bridge_confidence\": \"x\"}",
                             "{\"seeds\": [{\"system\": 4}, {}, 7], \"thinning\": \"other\"}",
                             "{\"thinning\": 3, \"vessel_mask_given\": \"x\"}",
                             "{\"portal_trunk_mm\": [1, 2]}", "{\"portal_trunk_mm\": null}",
                             "{\"portal_trunk_mm\": [1, 2, \"x\"]}", "{\"portal_trunk_mm\": 7}"}) {
        options = from_voxels_options(text);
        EXPECT_TRUE(options.seeds.empty()) << text;
        EXPECT_EQ(options.bridge_confidence, 0.25) << text;
        EXPECT_EQ(options.thinning, ThinningMethod::queue) << text;
        EXPECT_FALSE(options.portal_trunk_mm) << text;
    }
}

TEST_F(RemadeCaseTest, NothingLeftIsRefused) {
    Job job;
    const Mask nothing(patient_->mask.grid);
    EXPECT_THROW(remade(*patient_, nothing, *ct_, job), InputError);
}

}  // namespace
}  // namespace hepatica
