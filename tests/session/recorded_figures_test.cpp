// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of sessions as they are today: what frames show while a small patient is pulled, pressed,
// held in forceps, torn and injected, the commands that scripts become, and the settings that
// automatic quality chooses.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/flow/injection.h"
#include "core/session/quality_governor.h"
#include "core/session/recording.h"
#include "core/session/script.h"
#include "tests/session/new_session.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::expect_recorded;
using test::Figures;
using test::middle_of;
using test::new_session;
using test::small_patient;

std::span<const std::uint8_t> letters(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// What the frames of one session showed, each kind of number by itself: places, forces and entropy
// differ by orders of magnitude.
class Shown {
  public:
    void add(const Frame& frame) {
        positions_.insert(positions_.end(), frame.positions_mm.begin(), frame.positions_mm.end());
        counts_.insert(counts_.end(), {double(frame.step), double(frame.topology_version),
                                       double(frame.surface->size())});
        if (frame.grab) {
            add(places_, frame.grab->point_mm);
            add(places_, frame.grab->target_mm);
            forces_.push_back(frame.grab->force_un);
            counts_.push_back(frame.grab->at_limit);
        }
        if (frame.tool) add(*frame.tool);
        if (frame.tear) add(*frame.tear);
        add(frame.drug);
        times_.push_back(frame.time_s);
        const FrameStatistics& said = frame.statistics;
        counts_.insert(counts_.end(), {double(said.paused), double(said.diverged),
                                       double(said.automatic), double(said.linear_iterations)});
        times_.push_back(said.quality);
        words_ += said.message + "|" + said.setting + "\n";
    }

    Figures figures() const {
        return Figures()
            .add("positions", positions_)
            .add("places", places_)
            .add("forces", forces_)
            .add("counts", counts_)
            .add("times", times_)
            .add("tears", tears_)
            .add("words", letters(words_));
    }

  private:
    static void add(std::vector<double>& to, const Vec3& value) {
        to.insert(to.end(), value.begin(), value.end());
    }

    void add(const ToolView& tool) {
        for (const ToolView::Part& part : tool.parts) {
            add(places_, part.from_mm);
            add(places_, part.to_mm);
            places_.push_back(part.radius_mm);
        }
        add(places_, tool.centre_mm);
        add(places_, tool.tip_mm);
        add(places_, tool.at_mm);
        places_.push_back(tool.opening_mm);
        add(forces_, tool.force_un);
        forces_.push_back(tool.grip_un);
        counts_.push_back(tool.at_limit);
        for (const int vertex : tool.touched) counts_.push_back(vertex);
    }

    void add(const TearView& tear) {
        counts_.insert(counts_.end(), {double(tear.joints_broken), double(tear.pieces)});
        tears_.insert(tears_.end(), {tear.entropy_nats, tear.entropy_produced_nats, tear.leak_g_s,
                                     tear.leaked_g});
        words_ += tear.stopped_by + "\n";
        if (tear.origins)
            for (const int origin : *tear.origins) counts_.push_back(origin);
        if (tear.rims)
            for (const std::uint8_t rim : *tear.rims) counts_.push_back(rim);
        if (tear.loads)
            for (const float load : *tear.loads) tears_.push_back(load);
    }

    void add(const DrugView& drug) {
        times_.insert(times_.end(), {drug.time_s, drug.end_s});
        counts_.insert(counts_.end(),
                       {double(drug.version), double(drug.playing), double(drug.computing)});
        if (!drug.arrival_s) return;
        for (const float arrival : *drug.arrival_s)
            times_.push_back(std::isfinite(arrival) ? arrival : -1.0);
        counts_.push_back(drug.injection->tip->segment);
        places_.push_back(drug.injection->tip->arclength_mm);
    }

    std::vector<double> positions_, places_, forces_, counts_, times_, tears_;
    std::string words_;
};

// Gives the commands of each step, and looks at every `every`-th frame.
Figures seen(Session& session, const std::vector<std::vector<Command>>& steps, int every) {
    Shown shown;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        for (const Command& command : steps[k]) session.post(command);
        session.step();
        session.update_frame();
        if (k % static_cast<std::size_t>(every) == 0) shown.add(session.frame());
    }
    return shown.figures();
}

Vec3 along(int segment) {
    const auto& points =
        small_patient()->tree.segments[static_cast<std::size_t>(segment)].points_mm;
    const std::size_t m = points.size() / 2;
    return (points[m + 1] - points[m - 1]).normalized();
}

TEST(SessionFigures, OfWhatIsPulledInjectedAndSet) {
    const VesselTree& tree = small_patient()->tree;
    const Vec3 hand = middle_of(tree, 3);
    std::vector<std::vector<Command>> steps(60);
    steps[1] = {GrabPoint{hand}, InjectDrug{.point_mm = middle_of(tree, 0)}};
    for (int k = 2; k < 10; ++k) steps[k] = {MoveGrab{hand + 0.6 * k * Vec3(0.5, -1, 0.3)}};
    steps[10] = {SetDrugSpeed{3.0}, SetGravity{Vec3(0, 5000, -1000)}};
    steps[14] = {SetTether{8.0}, SetWall{0.6}};
    steps[18] = {SetPaused{true}};
    steps[20] = {SetDrugTime{0.4}, PlayDrug{false}};
    steps[22] = {SetPaused{false}, ReleaseGrab{}};
    steps[26] = {SetQuality{0.9}, PlayDrug{true}};
    steps[32] = {InjectDrug{.point_mm = middle_of(tree, 2),
                            .mass_flow_g_s = 1.1,
                            .void_fraction = 0.3,
                            .second_phase = "lipiodol",
                            .pressure_model = "consistent",
                            .drug_viscosity_pa_s = 0.006},
                 FinishInjection{}};
    steps[38] = {GrabVertex{5}, SetTether{-1.0}};  // the second is refused in words
    steps[39] = {MoveGrab{hand}};
    steps[44] = {RestoreSnapshot{}};
    steps[50] = {RemoveDrug{}};
    steps[54] = {ResetWorld{}};
    const auto session = new_session();
    expect_recorded("session", "settings", seen(*session, steps, 1));
}

TEST(SessionFigures, OfTools) {
    SceneSpec spec = default_scene();
    spec.contact = ContactSpec{.tools = true, .self = true};
    const VesselTree& tree = small_patient()->tree;
    const Vec3 place = middle_of(tree, 1), from = along(1).unitOrthogonal();
    std::vector<std::vector<Command>> steps(110);
    steps[1] = {AddTool{"sphere", 2.0, 0.0, -from, place, {}}};
    for (int k = 2; k < 14; ++k) steps[k] = {ShiftTool{-0.4 * from}};
    steps[16] = {AddTool{"capsule", 1.2, 15.0, -from, place, {}}, TurnTool{Vec3(0.2, 0.1, 0)}};
    for (int k = 17; k < 27; ++k) steps[k] = {MoveTool{place - 2.0 * from, 1.0 / (27 - k)}};
    steps[30] = {AddTool{"hook", 1.0, 14.0, -from, place, {}}};
    for (int k = 31; k < 45; ++k) steps[k] = {ShiftTool{-0.5 * from}};
    steps[48] = {AddTool{"forceps", 1.5, 16.0, -from, place, along(1).cross(from)}};
    for (int k = 50; k < 70; ++k) steps[k] = {CloseForceps{1.0 / (70 - k)}};
    for (int k = 75; k < 90; ++k) steps[k] = {ShiftTool{0.1 * from}};
    steps[92] = {OpenForceps{0.5}};
    steps[98] = {RemoveTool{}};
    steps[104] = {UseTools{false}};
    const auto session = new_session(spec);
    expect_recorded("session", "tools", seen(*session, steps, 3));
}

TEST(SessionFigures, OfTears) {
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const Vec3 place = middle_of(small_patient()->tree, 0);
    std::vector<std::vector<Command>> steps(90);
    steps[0] = {InjectDrug{.point_mm = points.front()}};
    steps[1] = {CutLine{place, place, 0.01}, GrabPoint{points.back()}};
    for (int k = 2; k < 50; ++k)
        steps[k] = {
            MoveGrab{points.back() + 0.15 * k * (points.back() - points.front()).normalized()}};
    steps[52] = {ReleaseGrab{}};
    const Vec3 other = middle_of(small_patient()->tree, 3);
    const Vec3 side = 12.0 * along(3).unitOrthogonal();
    steps[56] = {Blade{other - side, other}};
    steps[60] = {Blade{other, other + side}};
    steps[80] = {UseTear{false}};
    steps[84] = {UseTear{true, 0.5}};
    for (const TearStop stop : {TearStop::none, TearStop::entropy, TearStop::vertices}) {
        SceneSpec spec = default_scene();
        spec.tear = TearSpec{.stop = stop, .entropy_budget = 0.01, .vertex_budget = 8};
        const auto session = new_session(spec);
        expect_recorded("session", "tears_" + std::to_string(static_cast<int>(stop)),
                        seen(*session, steps, 4));
        steps.resize(54);  // the stops need no more
    }
}

// The commands of every script that comes with the program, and of one that has every action.
TEST(SessionFigures, OfScripts) {
    const auto commands = [](const Script& script, double dt_s) {
        std::string text = script.name + "\n";
        if (script.scene) text += to_json(*script.scene).dump() + "\n";
        for (const auto& step : schedule(script, small_patient()->tree, dt_s, 300))
            for (const Command& command : step) text += to_json(command).dump() + "\n";
        return text;
    };
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(HEPATICA_SOURCE_DIR) / "assets/scripts"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    Figures figures;
    for (const fs::path& file : files)
        figures.add(file.stem().string(), letters(commands(read_script(file), 1.0 / 60)));
    const std::string all = R"({"scene": {"deform": {"quality": 0.25}, "contact": {}, "tear": {}},
      "actions": [
      {"at_s": 0, "do": "inject", "where": {"share_of_longest_path": 0.1}, "mass_flow_g_s": 2},
      {"at_s": 0.1, "do": "grab", "where": {"point_mm": [1, 2, 3]}},
      {"at_s": 0.1, "do": "move", "by_mm": [9, -3, 1], "over_s": 0.5},
      {"at_s": 0.7, "do": "move", "by_mm": [0, 3, 1], "over_s": 0},
      {"at_s": 1, "do": "release"},
      {"at_s": 1.2, "do": "tool", "tool": "forceps", "radius_mm": 1.5, "length_mm": 20,
       "direction": [0, 1, 0], "side": [0, 0, 1], "where": {"share_of_longest_path": 0.75}},
      {"at_s": 1.2, "do": "move_tool", "by_mm": [0, 0, -10], "over_s": 0.6},
      {"at_s": 1.4, "do": "close_forceps", "over_s": 0.5},
      {"at_s": 2, "do": "move_tool", "to_mm": [4, 5, 6], "over_s": 0.3},
      {"at_s": 2.4, "do": "open_forceps", "over_s": 0.2},
      {"at_s": 2.7, "do": "remove_tool"},
      {"at_s": 3, "do": "cut_line", "from": {"share_of_longest_path": 0.4},
       "to": {"share_of_longest_path": 0.6}, "strength": 0.1},
      {"at_s": 3.1, "do": "blade", "from_mm": [1, 2, 3], "to_mm": [9, 2, 3], "over_s": 0.5},
      {"at_s": 4, "do": "set_gravity", "gravity_mm_per_s2": [0, 9806.65, 0]}]})";
    for (const double dt_s : {1.0 / 60, 0.03})
        figures.add("every_" + std::to_string(static_cast<int>(1000 * dt_s)),
                    letters(commands(script_of(all, "every.json"), dt_s)));
    std::vector<double> places;
    for (const double share : {0.0, 0.1, 0.5, 0.93, 1.0}) {
        const Vec3 point = point_on_longest_path(small_patient()->tree, share);
        places.insert(places.end(), point.begin(), point.end());
    }
    expect_recorded("session", "scripts", figures.add("places", places));
}

// Frames that get slower and quicker again, some of them late without a cause.
TEST(SessionFigures, OfAutomaticQuality) {
    std::vector<double> chosen;
    for (const double speed : {0.4, 1.0, 2.5}) {
        const std::vector<double> costs{2.0, 5.0, 9.0, 14.0, 30.0};
        QualityGovernor governor(costs, {0.5, 0.25, 0.12, 0.06, 0.03});
        std::size_t at = governor.start(16.0);
        for (int frame = 0; frame < 2000; ++frame) {
            const bool late = frame % 37 == 0;
            const double load = speed * (1.0 + 0.5 * std::sin(frame / 150.0));
            at = governor.next(at, load * costs[at] + (late ? 20.0 : 0.0), 16.0);
            chosen.push_back(static_cast<double>(at));
        }
    }
    expect_recorded("session", "automatic", Figures().add("chosen", chosen));
}

}  // namespace
}  // namespace hepatica
