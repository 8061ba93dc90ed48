// SPDX-License-Identifier: GPL-3.0-or-later
// The way from nothing to a played session, by the real program, on a small synthetic patient.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/patient/patient_case.h"
#include "core/session/recording_file.h"
#include "core/session/script.h"
#include "core/session/session.h"
#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;
using test::Tour;

TEST_F(Tour, PhantomSaysWhatItMade) {
    for (const char* key : {"truth_tree", "truth_mask"})
        EXPECT_TRUE(fs::exists(phantom_.value(key, "")));
    ASSERT_EQ(phantom_["ct"].size(), 2u);
    for (const auto& made : phantom_["ct"]) EXPECT_TRUE(fs::exists(made.get<std::string>()));
    EXPECT_GT(phantom_["segments"], 10);
}

TEST_F(Tour, ReconstructHoldsWhatIsPromised) {
    EXPECT_EQ(case_["image"]["dims"], Json({128, 128, 96}));
    EXPECT_FALSE(case_["stages"].empty());
    for (const char* key : {"voxels", "components", "tunnels", "cavities"}) {
        EXPECT_TRUE(case_["mask"].contains(key));
        EXPECT_TRUE(case_["skeleton"].contains(key));
    }
    for (const char* key : {"components", "tunnels", "cavities"})
        EXPECT_EQ(case_["mask"][key], case_["skeleton"][key]) << "thinning keeps the topology";
    EXPECT_GT(case_["tree"]["bifurcations"], 5);
    EXPECT_GT(case_["mesh"]["min_dihedral_deg"], 10.0);
    EXPECT_TRUE(case_["mesh"]["closed"]);
    for (const char* name : {"case.json", "mask.nii.gz", "skeleton.nii.gz", "tree.vtp", "tree.swc",
                             "surface.vtp", "mesh.vtu"})
        EXPECT_TRUE(fs::exists(folder() / "p.hep" / name)) << name;
}

TEST_F(Tour, CompareFindsTheTruthItself) {
    const Json found = answer({"compare", path("p.hep"), "--truth-tree", path("p/truth_tree.vtp"),
                               "--truth-mask", path("p/truth_mask.nii.gz")});
    EXPECT_GT(found["dice"], 0.99);
    EXPECT_LT(found["centreline_mean_mm"], 1.0);  // half a voxel and a bit
    for (const char* key : {"cldice", "centreline_p95_mm", "radius_mae_mm", "bifurcation_recall",
                            "bifurcation_precision"})
        EXPECT_TRUE(found.contains(key)) << key;
}

TEST_F(Tour, CompareReadsTreesInEveryFormat) {
    const VesselTree tree = read_tree_vtp(path("p/truth_tree.vtp"));
    for (const char* name : {"truth.swc", "truth.json"}) {
        write_tree(path(name), tree);
        const Json found = answer({"compare", path("p.hep"), "--truth-tree", path(name),
                                   "--truth-mask", path("p/truth_mask.nii.gz")});
        EXPECT_LT(found.value("centreline_mean_mm", 99.0), 1.0) << name;
    }
}

TEST_F(Tour, EditsAreMadeListedAndTakenBack) {
    const Json before = answer({"edit", path("p.hep"), "--list"});
    EXPECT_TRUE(before["edits"].empty());
    // The end of the first line of the tree's table: a place on a vessel.
    const VesselTree tree = read_tree_vtp(path("p.hep/tree.vtp"));
    const VesselSegment& last = tree.segments.back();
    const Vec3 at = last.points_mm[last.points_mm.size() / 2];
    std::ofstream(path("edits.json")) << "[{\"edit\": \"delete_branch\", \"at_mm\": [" << at.x()
                                      << ", " << at.y() << ", " << at.z() << "]}]";
    const Json after =
        answer({"edit", path("p.hep"), "--edits", path("edits.json"), "--out", path("e.hep")});
    EXPECT_EQ(after["edits"].size(), 1u);
    EXPECT_LT(after["tree"]["length_mm"], before["tree"]["length_mm"]);
    EXPECT_EQ(answer({"edit", path("e.hep"), "--list"})["edits"].size(), 1u);
    const Json back = answer({"edit", path("e.hep"), "--undo", "1"});
    EXPECT_EQ(back["tree"], before["tree"]);
    EXPECT_EQ(back["mesh"], before["mesh"]);
    EXPECT_EQ(run_cli({"edit", path("e.hep"), "--undo", "1"}).exit_code, 2);
}

// A label map of a whole body part, cropped to what it shows, as segmentation programs save it.
TEST_F(Tour, LabelMapsServeAsMasksByTheirLabels) {
    Job job;
    const LabelMap vessels = read_label_map(path("p/truth_mask.nii.gz"), job);
    Grid box = vessels.grid;
    const Index3 start{1, 2, 3};
    for (int a = 0; a < 3; ++a) box.dims[a] -= 2 * start[a];
    box.origin_mm = vessels.grid.to_mm(start[0], start[1], start[2]);
    LabelMap labels(box);
    for (int z = 0; z < box.dims[2]; ++z)
        for (int y = 0; y < box.dims[1]; ++y)
            for (int x = 0; x < box.dims[0]; ++x) {
                const bool vessel = vessels.at(x + start[0], y + start[1], z + start[2]) != 0;
                labels.at(x, y, z) = vessel ? (x < box.dims[0] / 2 ? 364 : 363) : 5;
            }
    const std::vector<SegmentDescription> segments{{364, "portal"}, {363, "hepatic"}, {5, "liver"}};
    write_segmentation(path("body.seg.nrrd"), labels, segments);
    const std::vector<std::string> arguments{
        "reconstruct",  path("p/ct"), "--vessel-mask", path("body.seg.nrrd"),
        "--tetrahedra", "3000",       "--out",         path("labels.hep")};
    const Outcome all = run_cli(arguments);
    EXPECT_EQ(all.exit_code, 1);
    EXPECT_NE(all.errors.find("--vessel-label"), std::string::npos) << all.errors;
    std::vector<std::string> named = arguments;
    named.insert(named.end(), {"--vessel-label", "364=portal,363=hepatic"});
    const Json made = answer(named);
    EXPECT_EQ(made["mask"]["voxels"], case_["mask"]["voxels"]);
    std::set<std::string> systems;
    for (const Json& system : made["tree"]["systems"]) {
        systems.insert(system["system"].get<std::string>());
        EXPECT_GT(system["confidence"], 0.5) << system;
    }
    EXPECT_EQ(systems, (std::set<std::string>{"hepatic", "portal"}));
}

// Scattered voxels that are no numbers are mended; the answer says how many there were.
TEST_F(Tour, AScanWithScatteredHolesIsReconstructedLikeTheWholeOne) {
    Job job;
    const Volume ct = read_volume(path("p/ct.nii.gz"), job);
    FloatVolume holed(ct.grid);
    std::size_t holes = 0;
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const bool hole = (i * 2654435761u) % 50 == 0;  // 2 %
        holes += hole ? 1 : 0;
        holed.voxels[i] =
            hole ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(ct.voxels[i]);
    }
    write_nifti(path("holed.nii.gz"), holed);
    const auto reconstructed = [](const std::string& scan) {
        return answer({"reconstruct", path(scan), "--liver-mask", path("p/liver.nii.gz"), "--out",
                       path("holed.hep"), "--tetrahedra", "3000", "--replace"});
    };
    const Json whole = reconstructed("p/ct.nii.gz"), mended = reconstructed("holed.nii.gz");
    const double length_mm = whole["tree"]["length_mm"];
    EXPECT_NEAR(mended["tree"]["length_mm"], length_mm, 0.05 * length_mm);
    const VesselTree truth = read_tree(path("p/truth_tree.vtp"));
    const Vec3 true_root = truth.segments[roots(truth).front()].points_mm.front();
    const Json& root = whole["tree"]["systems"][0]["roots"][0]["at_mm"];
    EXPECT_LT((Vec3(root[0], root[1], root[2]) - true_root).norm(), 4.0) << root;
    EXPECT_NE(mended["warnings"].dump().find(std::to_string(holes) + " of "), std::string::npos)
        << mended["warnings"];
}

TEST_F(Tour, SimulatesRecordsAndReplaysAlikeForAnyNumberOfThreads) {
    std::string hash;
    for (const char* threads : {"1", "2", "4"}) {
        const Json played =
            answer({"simulate", path("p.hep"), "--script", HEPATICA_ASSETS "/scripts/drag.json",
                    "--steps", "90", "--threads", threads, "--record", path("drag.hrec")});
        EXPECT_EQ(played["steps"], 90);
        EXPECT_TRUE(played["finite"]);
        if (hash.empty()) hash = played["state_hash"];
        EXPECT_EQ(played["state_hash"], hash) << threads << " threads";
    }
    const Json replayed = answer({"replay", path("drag.hrec"), "--verify"});
    EXPECT_EQ(replayed["steps"], 90);
    EXPECT_TRUE(replayed["diverged_at"].is_null());
    EXPECT_EQ(replayed["state_hash"], hash);
    EXPECT_EQ(replayed["began_at"], 0);
    // Moved away from its case it names the hash, and takes the case that is given.
    fs::create_directories(path("moved"));
    fs::copy_file(path("drag.hrec"), path("moved/drag.hrec"));
    const Outcome alone = run_cli({"replay", path("moved/drag.hrec")});
    EXPECT_EQ(alone.exit_code, 1);
    EXPECT_NE(alone.errors.find("--patient"), std::string::npos) << alone.errors;
    EXPECT_EQ(answer({"replay", path("moved/drag.hrec"), "--patient", path("p.hep")})["state_hash"],
              hash);
    std::ifstream recorded(path("drag.hrec"));
    const std::string text{std::istreambuf_iterator<char>(recorded), {}};
    EXPECT_EQ(text.find("p.hep"), std::string::npos);
    EXPECT_EQ(text.find(fs::path(path("p.hep")).parent_path().string()), std::string::npos);
}

// What the program does not have is null and not 0; the expected error names its reference.
TEST_F(Tour, SimulateSaysWhatErrorToExpectAndClaimsNothingElse) {
    const Json played =
        answer({"simulate", path("p.hep"), "--script", HEPATICA_ASSETS "/scripts/drag.json",
                "--steps", "60", "--quality", "1", "--fit-velocity-error"});
    for (const char* key : {"contacts_max", "joints_broken", "vertices_split", "entropy"})
        EXPECT_TRUE(played.at(key).is_null()) << key;
    EXPECT_GT(played["expected_error"], 0.0);
    EXPECT_NE(played["error_reference"].get<std::string>().find("synthetic patient"),
              std::string::npos);
    EXPECT_EQ(played["quality"], 1.0);
    EXPECT_TRUE(played["velocity_error_fit"].contains("r_squared"));
}

TEST_F(Tour, SimulateBearsAScriptThatPausesAtOnce) {
    std::ofstream(path("paused.json"))
        << R"({"name": "paused", "actions": [{"at_s": 0, "do": "set_paused", "paused": true}]})";
    const Json played =
        answer({"simulate", path("p.hep"), "--script", path("paused.json"), "--steps", "5"});
    EXPECT_EQ(played["steps"], 0);
    EXPECT_TRUE(played["step_ms"]["median"].is_null());
    EXPECT_TRUE(played["real_time_factor"].is_null());
}

// The session changes its setting as it goes; the recording holds what it chose.
TEST_F(Tour, AutomaticQualityReplaysToTheLastBit) {
    const Json played =
        answer({"simulate", path("p.hep"), "--script", HEPATICA_ASSETS "/scripts/drag.json",
                "--steps", "120", "--automatic", "--record", path("automatic.hrec")});
    const Json replayed = answer({"replay", path("automatic.hrec"), "--verify"});
    EXPECT_EQ(replayed["state_hash"], played["state_hash"]);
}

// Before the play, which may be long.
TEST_F(Tour, SimulateRefusesWhatASceneWithoutABodyCannotDo) {
    std::ofstream(path("flows.json"))
        << R"({"name": "f", "scene": {"name": "f", "flow": {}}, "actions": []})";
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--final-mesh", path("none.vtu")},
          {"--quality", "0.5"},
          {"--automatic"},
          {"--fit-velocity-error"}}) {
        std::vector<std::string> call{"simulate",         path("p.hep"), "--script",
                                      path("flows.json"), "--steps",     "3"};
        call.insert(call.end(), words.begin(), words.end());
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << words[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(words[0] + ": the scene has no deform"), std::string::npos)
            << run.errors;
        EXPECT_EQ(run.errors.find("Simulating"), std::string::npos) << run.errors;
    }
}

#ifdef HEPATICA_WINDOW_PROGRAM
// A recording of the window begins amid a play whose setting is chosen by the session. What it
// chose is recorded, so that a picture of it must not choose again, however slow this computer is.
TEST_F(Tour, RenderPlaysWithTheRecordedSettings) {
    const auto patient = std::make_shared<const PatientCase>(read_case(path("p.hep")));
    SceneSpec scene = default_scene();
    scene.dt_s = 1e-3;  // no step keeps to such a budget
    Job job;
    Session session(patient, scene, job);
    const Vec3 held = point_on_longest_path(patient->tree, 0.5);
    session.post(SetQuality{1.0});
    session.post(GrabPoint{held});
    session.post(MoveGrab{held + Vec3(3, 0, 0)});
    session.step(job);
    Recording recording;
    session.record_from_now([&](const Recording& start) {
        recording = start;
        return [&](RecordedStep step) { recording.steps.push_back(std::move(step)); };
    });
    for (int i = 0; i < 40; ++i) session.step(job);
    session.record_from_now({});
    session.step(job);
    ASSERT_EQ(recording.steps.size(), 40u);
    auto begin = std::make_shared<Keyframe>(*recording.begin);
    begin->automatic = true;
    recording.begin = begin;
    write_recording(path("amid.hrec"), recording);
    const std::vector<std::string> call{"render",          path("p.hep"), "--recording",
                                        path("amid.hrec"), "--out",       path("amid.png"),
                                        "--size",          "64,48"};
    const Outcome drawn = run_cli(call);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
    EXPECT_EQ(drawn.errors.find("diverged"), std::string::npos) << drawn.errors;
    // A time that is not in it is refused, or said to be behind its end.
    const auto at = [&](const std::string& time_s) {
        std::vector<std::string> timed = call;
        timed.insert(timed.end(), {"--time-s", time_s});
        return run_cli(timed);
    };
    EXPECT_EQ(at("-3").exit_code, 2);
    const Outcome late = at("900");
    EXPECT_EQ(late.exit_code, 0) << late.errors;
    EXPECT_NE(late.errors.find("ends at 0.04"), std::string::npos) << late.errors;
    // What is another play is said to be one.
    recording.steps[20].state_hash ^= 1;
    write_recording(path("amid.hrec"), recording);
    const Outcome other = run_cli(call);
    EXPECT_EQ(other.exit_code, 0) << other.errors;
    EXPECT_NE(other.errors.find("diverged from the recording at step 21"), std::string::npos)
        << other.errors;
}
#endif

TEST_F(Tour, SkeletonLeavesAllPicturesOrNone) {
    const std::string mask = path("p/truth_mask.nii.gz");
    ASSERT_EQ(run_cli({"skeleton", mask, "--out", path("stages")}).exit_code, 0);
    const auto first = fs::file_size(path("stages/1_thinned.png"));
    ASSERT_GT(fs::file_size(path("stages/2_crowded_regions.png")), first);
    const Outcome full = run_cli({"skeleton", mask, "--out", path("half")},
                                 {.file_bytes = static_cast<long>(first)});
    EXPECT_EQ(full.exit_code, 1) << full.errors;
    EXPECT_FALSE(fs::exists(path("half/1_thinned.png")));
    // A straight vessel has nothing to show, which is said.
    Mask line(Grid{.dims = {20, 20, 20}});
    for (int z = 2; z < 18; ++z) line.at(10, 10, z) = 1;
    write_nifti(path("line.nii.gz"), line);
    const Outcome straight = run_cli({"skeleton", path("line.nii.gz"), "--out", path("none")});
    EXPECT_EQ(straight.exit_code, 0) << straight.errors;
    EXPECT_NE(straight.errors.find("no crowded region"), std::string::npos) << straight.errors;
    EXPECT_FALSE(fs::exists(path("none")));
}

// Nothing moves, so that the share that is missed of the motion is no number.
TEST_F(Tour, WhatIsNoNumberIsPrintedAsNone) {
    std::ofstream(path("still.json")) << R"({"name": "still", "actions": []})";
    const std::vector<std::string> call{"bench",  "drag",     path("p.hep"),     "--motion",
                                        "script", "--script", path("still.json")};
    EXPECT_TRUE(answer(call)["motions"][0]["error"].is_null());
    const Outcome run = run_cli(call);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.output.find("nan"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("none"), std::string::npos) << run.output;
}

TEST_F(Tour, TradeoffOfAPatientEndsInItsBudget) {
    const Json measured =
        answer({"tradeoff", path("p.hep"), "--out", path("tradeoff"), "--budget", "15"});
    EXPECT_FALSE(measured["points"].empty());
    EXPECT_FALSE(measured["pareto"].empty());
    for (const Json& point : measured["not_measured"])
        EXPECT_FALSE(point["not_measured"].get<std::string>().empty());
    std::set<std::string> regions;
    std::set<int> meshes;
    for (const char* list : {"points", "not_measured"})
        for (const Json& point : measured[list]) {
            regions.insert(point["region"].get<std::string>());
            meshes.insert(point["elements"].get<int>());
        }
    EXPECT_EQ(regions.size(), 2u);
    EXPECT_EQ(meshes.size(), 2u);
    for (const char* name : {"tradeoff/tradeoff.csv", "tradeoff/tradeoff.svg"})
        EXPECT_TRUE(fs::exists(path(name))) << name;
}

TEST_F(Tour, TheDialOfAPatientStaysInTheCaseAndIsMeasuredOnce) {
    const Json begun = answer({"dial", path("p.hep"), "--budget", "1"});
    EXPECT_GE(begun["measured"].size(), 1u);
    const Json played = answer({"simulate", path("p.hep"), "--script",
                                HEPATICA_ASSETS "/scripts/drag.json", "--steps", "5"});
    EXPECT_EQ(played["error_reference"], begun["reference"]);
    const Json whole = answer({"dial", path("p.hep")});
    EXPECT_TRUE(whole["complete"]);
    EXPECT_GE(begun["measured"].size() + whole["measured"].size(), 6u);
    double cost = 0.0, error = 1.0;
    for (const Json& point : whole["front"]) {
        EXPECT_GT(point["frame_ms"], cost);
        EXPECT_LT(point["error_relative"], error);
        cost = point["frame_ms"];
        error = point["error_relative"];
    }
    EXPECT_TRUE(answer({"dial", path("p.hep")})["measured"].empty());
    fs::remove(path("p.hep/dial.json"));
}

// Settings of the emulated device, as a case may hold them: to measure them takes minutes.
TEST_F(Tour, TheDialOfACaseIsPlayedWhereItWasMeasured) {
    const Json begun = answer({"dial", path("p.hep"), "--budget", "1"});
    for (const Json& point : begun["front"]) EXPECT_EQ(point["back_end"], "cpu");
    Json dial = Json::parse(std::ifstream(path("p.hep/dial.json")));
    dial["version"] = 4;
    for (Json& point : dial["points"]) {
        point["back_end"] = "cuda-emulated";
        point["device"] = "emulated on the processor";
    }
    std::ofstream(path("p.hep/dial.json")) << dial;
    const std::vector<std::string> script{"simulate", path("p.hep"),
                                          "--script", HEPATICA_ASSETS "/scripts/drag.json",
                                          "--steps",  "2"};
    std::vector<std::string> on_device = script;
    on_device.insert(on_device.end(), {"--backend", "cuda-emulated"});
    const Json device = answer(on_device);
    EXPECT_EQ(device["error_reference"], begun["reference"]);
    EXPECT_GT(device["gpu"]["steps_on_device"], 0);
    const Json processor = answer(script);
    EXPECT_NE(processor["error_reference"], begun["reference"]);
    EXPECT_TRUE(processor["gpu"].is_null());
    const Outcome run = run_cli(script);
    EXPECT_NE(run.errors.find("(cuda-emulated) are left out"), std::string::npos) << run.errors;
    fs::remove(path("p.hep/dial.json"));
}

TEST_F(Tour, TradeoffListsADeviceBesideTheProcessor) {
    const Json measured = answer({"tradeoff", path("p.hep"), "--out", path("both"), "--budget",
                                  "10", "--backend", "cuda-emulated"});
    std::map<std::string, int> points;
    for (const char* list : {"points", "not_measured"})
        for (const Json& point : measured[list]) ++points[point["back_end"].get<std::string>()];
    EXPECT_EQ(points.size(), 2u);
    EXPECT_EQ(points["cpu"], points["cuda-emulated"]);
    const Outcome beam = run_cli({"tradeoff", "--out", path("beam"), "--backend", "cuda-emulated"});
    EXPECT_EQ(beam.exit_code, 2);
    EXPECT_NE(beam.errors.find("Give a CASE"), std::string::npos) << beam.errors;
}

TEST_F(Tour, TradeoffOfATearTakesNoPatientAndNoContact) {
    const Outcome patient = run_cli({"tradeoff", path("p.hep"), "--out", path("torn"), "--tear"});
    EXPECT_EQ(patient.exit_code, 2);
    EXPECT_NE(patient.errors.find("Leave CASE and --quick out"), std::string::npos)
        << patient.errors;
    const Outcome both = run_cli({"tradeoff", "--out", path("torn"), "--tear", "--contact"});
    EXPECT_NE(both.exit_code, 0);
    EXPECT_NE(both.errors.find("--contact"), std::string::npos) << both.errors;
}

TEST_F(Tour, BenchDragSaysWhatAHandsMotionCostsAndMisses) {
    const Json measured = answer({"bench", "drag", path("p.hep"), "--motion", "jerk", "--motion",
                                  "script", "--script", HEPATICA_ASSETS "/scripts/drag.json",
                                  "--steps-csv", path("steps.csv"), "--references", path("refs")});
    ASSERT_EQ(measured["motions"].size(), 2u);
    for (const Json& row : measured["motions"]) {
        EXPECT_LE(row["median_ms"], row["p95_ms"]);
        EXPECT_LE(row["p95_ms"], row["p99_ms"]);
        EXPECT_LE(row["p99_ms"], row["longest_ms"]);
        EXPECT_GT(row["frames_in_time"], 0.0);
        EXPECT_GT(row["error"], 0.0);
        EXPECT_LT(row["error"], 1.0);
        EXPECT_LE(row["error_rms_mm"], row["error_largest_mm"]);
    }
    EXPECT_EQ(measured["motions"][0]["steps"], 72);
    std::ifstream csv(path("steps.csv"));
    int lines = 0;
    for (std::string line; std::getline(csv, line);) ++lines;
    EXPECT_EQ(lines, 1 + measured["motions"][0]["steps"].get<int>() +
                         measured["motions"][1]["steps"].get<int>());
    const Json whole = answer({"bench", "drag", path("p.hep"), "--motion", "jerk", "--whole",
                               "--no-error", "--setting", R"({"substeps": 2})"});
    EXPECT_EQ(whole["setting"]["substeps"], 2);
    EXPECT_EQ(whole["motions"][0]["live_median"], 1.0);
    EXPECT_TRUE(whole["motions"][0]["error"].is_null());
}

TEST_F(Tour, SceneListsTheParts) {
    const Json scene = answer({"scene", path("p.hep")});
    ASSERT_EQ(scene["parts"].size(), 3u);
    for (const Json& part : scene["parts"])
        for (const char* key : {"name", "bytes", "ms"}) EXPECT_TRUE(part.contains(key));
}

TEST_F(Tour, SceneListsWhatToolsSelfContactAndTearsAddToTheBody) {
    std::ofstream(path("all.json"))
        << R"({"case": "p.hep", "deform": {"quality": 0}, "contact": {}, "tear": {}})";
    const Json scene = answer({"scene", path("all.json")});
    std::vector<std::string> names;
    for (const Json& part : scene["parts"]) {
        names.push_back(part["name"]);
        EXPECT_GT(part["bytes"], 0) << part.dump();
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"shape", "deform", "self-contact", "tools", "tear"}));
}

TEST_F(Tour, DiagnoseAnswers) {
    EXPECT_TRUE(answer({"diagnose"}).contains("libraries"));
}

}  // namespace
}  // namespace hepatica
