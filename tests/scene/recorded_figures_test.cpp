// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of scenes as they are today: a small patient who is pulled, held and let go in several
// scenes, his table of branches, and which vessel each vertex belongs to.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/bleeding.h"
#include "core/scene/branch_table.h"
#include "core/scene/crossings.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/scene_spec.h"
#include "core/scene/surface_anatomy.h"
#include "core/scene/tools/tool_choice.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/session/small_patient.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;
using test::middle_of;
using test::small_patient;

std::span<const std::uint8_t> text_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(SceneFigures, OfBranchesAndVertices) {
    const auto patient = small_patient();
    Job job;
    Figures figures;
    std::vector<BranchLabel> labels;
    std::vector<double> shares;
    for (std::size_t s = 0; s < patient->tree.segments.size(); ++s) {
        labels.push_back({static_cast<int>(s % 9), 0.1 * static_cast<double>(s)});
        shares.push_back(1.0 / static_cast<double>(s + 1));
    }
    figures.add("csv", text_of(branch_table_csv(branch_rows(patient->tree, labels, shares))));
    figures.add("bare_csv", text_of(branch_table_csv(branch_rows(patient->tree, {}, {}))));
    const SurfaceAnatomy anatomy(patient->tree, patient->mesh.vertices_mm, job);
    std::vector<double> places;
    for (std::size_t v = 0; v < patient->mesh.vertices_mm.size(); v += 3) {
        const TreePoint point = anatomy.tree_point(static_cast<int>(v));
        places.push_back(point.segment);
        places.push_back(point.arclength_mm);
    }
    figures.add("places", places);
    expect_recorded("scene", "branches", figures);
}

// Pulled, held, let go and put back; what each frame shows.
Figures played(SceneSpec spec) {
    Job job;
    World world(small_patient(), spec, job);
    Figures figures;
    figures.add("spec", text_of(to_json(spec).dump()));
    const Vec3 held = middle_of(small_patient()->tree, 3);
    std::vector<double> shown, ledger;
    for (int k = 0; k < 24; ++k) {
        if (k == 2) world.deform()->grab(held);
        if (k > 2 && k < 14) world.deform()->move_grab(held + k * Vec3(0.5, -0.9, 0.4));
        if (k == 15) world.deform()->release();
        const StepReport report = world.step();
        for (const double value : {report.energy.kinetic, report.energy.elastic, report.energy.grab,
                                   report.energy.tether, double(report.asleep)})
            ledger.push_back(value);
        if (k % 6 != 5) continue;
        Frame frame;
        world.fill(frame);
        shown.insert(shown.end(), frame.positions_mm.begin(), frame.positions_mm.end());
        shown.push_back(static_cast<double>(frame.surface->size()));
        const TreePoint near = world.place_near(held + Vec3(1, 1, 1));
        shown.push_back(near.segment);
        shown.push_back(near.arclength_mm);
    }
    world.reset();
    Frame frame;
    world.fill(frame);
    shown.insert(shown.end(), frame.positions_mm.begin(), frame.positions_mm.end());
    return figures.add("shown", shown).add("ledger", ledger).add("time", world.time_s());
}

TEST(SceneFigures, OfPlays) {
    SceneSpec spec = default_scene();
    expect_recorded("scene", "default", played(spec));
    spec.deform->gravity_mm_per_s2 = Vec3(0, 4000, -2000);
    spec.deform->tether_pa_per_mm2 = 3.0;
    spec.deform->wall_mm = 0.5;
    spec.deform->fixed = FixedEnds::roots;
    expect_recorded("scene", "heavy", played(spec));
    spec = default_scene();
    spec.flow.reset();
    spec.dt_s = 0.008;
    expect_recorded("scene", "without_flow", played(spec));
}

// Everything that can be done to a world: tools that press, hold and turn, cuts and tears that
// bleed, injections, and the way back.
class Handling {
  public:
    explicit Handling(const SceneSpec& spec) : world_(small_patient(), spec, job_) {
        const auto& line = tree_.segments[1].points_mm;
        along_ = (line[line.size() / 2 + 1] - line[line.size() / 2 - 1]).normalized();
        across_ = along_.unitOrthogonal();
    }

    Figures figures() {
        for (int k = 0; k < 60; ++k) {
            use_tools(k);
            inject(k);
            if (body_.tears()) cut_and_pull(k);
            world_.step();
            Frame frame;
            world_.fill(frame);
            if (k % 4 == 0)
                shapes_.insert(shapes_.end(), frame.positions_mm.begin(), frame.positions_mm.end());
            if (frame.tool) note_tool(*frame.tool);
            if (frame.grab) note_hand(*frame.grab);
            if (frame.tear) note_tears(frame);
            note_drug(k, frame.drug);
            if (k % 10 == 9) crossings_.push_back(crossing_pairs(body_));
            if (k == 26 || k == 50) go_back();
        }
        return Figures()
            .add("shapes", shapes_)
            .add("tools", tools_)
            .add("hand", hand_)
            .add("tears", tears_)
            .add("shown_tears", shown_tears_)
            .add("crossings", crossings_)
            .add("drug", drug_)
            .add("checkpoints", text_of(checkpoints_))
            .add("mass_error", flow_.mass_error_relative() < 1e-9);
    }

  private:
    void use_tools(int k) {
        if (k == 1) body_.add_tool({"forceps", 1.5, 16.0, -across_, along_.cross(across_)}, place_);
        if (k > 2 && k < 12) body_.close_jaws(1.0 / (12 - k));
        if (k > 12 && k < 18)
            body_.lead_tool(body_.tool()->parts[0].shape.centre_mm + 0.2 * across_);
        if (k == 18) body_.turn_tool(0.3 * along_);
        if (k == 22) body_.open_jaws(0.5);
        if (k == 24) body_.add_tool({"hook", 1.0, 14.0, -across_, {}}, place_);
        if (k == 28) body_.remove_tool();
    }

    void inject(int k) {
        if (k == 2) flow_.inject({world_.place_near(cut_), 2.0, 0.0, "carrier", "regime"});
        if (k == 20) flow_.inject({world_.place_near(place_), 1.0, 0.3, "gas", "consistent"});
        if (k == 21) flow_.finish_injection();
        if (k == 30) flow_.set_time(0.7);
        if (k == 31) flow_.set_speed(4.0);
    }

    void cut_and_pull(int k) {
        const Vec3 end = tree_.segments[0].points_mm.back();
        if (k == 29) body_.cut_line(tree_, cut_, cut_, 0.0);
        if (k == 30) body_.grab(end);
        if (k > 30 && k < 45) body_.move_grab(end + 0.3 * k * along_);
        if (k == 45) body_.release();
        if (k == 46) body_.cut_line(tree_, cut_, middle_of(tree_, 2), 1.0);
        if (k == 48) body_.cut(tree_, cut_ - 15.0 * across_, cut_ + 15.0 * across_);
        if (k == 56) body_.mend();
    }

    void note_tool(const ToolView& tool) {
        for (const Vec3& v : {tool.tip_mm, tool.at_mm, Vec3(1e-5 * tool.force_un)})
            tools_.insert(tools_.end(), v.begin(), v.end());
        tools_.push_back(tool.opening_mm);
        tools_.push_back(1e-5 * tool.grip_un);
        tools_.push_back(tool.at_limit);
        for (const int vertex : tool.touched) tools_.push_back(vertex);
    }

    void note_hand(const GrabView& hand) {
        for (const Vec3& v : {hand.point_mm, hand.target_mm})
            hand_.insert(hand_.end(), v.begin(), v.end());
        hand_.push_back(1e-5 * hand.force_un);
        hand_.push_back(hand.at_limit);
    }

    // What is painted of a tear.
    void note_shown_tears(const TearView& tear) {
        shown_tears_.push_back(static_cast<double>(tear.stopped_by.size()));
        shown_tears_.push_back(tear.entropy_produced_nats);
        if (tear.origins)
            shown_tears_.insert(shown_tears_.end(), tear.origins->begin(), tear.origins->end());
        if (tear.rims)
            shown_tears_.insert(shown_tears_.end(), tear.rims->begin(), tear.rims->end());
        if (tear.loads)
            shown_tears_.insert(shown_tears_.end(), tear.loads->begin(), tear.loads->end());
        if (!tear.weak_edges) return;
        for (const auto& [a, b] : *tear.weak_edges)
            shown_tears_.insert(shown_tears_.end(), {double(a), double(b)});
    }

    void note_tears(const Frame& frame) {
        note_shown_tears(*frame.tear);
        shown_tears_.push_back(body_.mass_error_relative() < 1e-12);
        tears_.insert(tears_.end(),
                      {double(frame.tear->joints_broken), double(frame.tear->pieces),
                       frame.tear->entropy_nats, frame.tear->leak_g_s, frame.tear->leaked_g});
        tears_.push_back(static_cast<double>(frame.positions_mm.size()));
        tears_.push_back(body_.critical_opening_mm());
        for (const ThroughTear& torn : body_.torn_through(tree_)) {
            tears_.push_back(torn.at.segment);
            tears_.push_back(torn.at.arclength_mm);
            tears_.push_back(torn.area_mm2);
        }
    }

    void note_drug(int k, const DrugView& drug) {
        drug_.insert(drug_.end(), {drug.time_s, drug.end_s, double(drug.playing)});
        if (k % 10 == 0 && drug.arrival_s)
            for (const float arrival : *drug.arrival_s)
                drug_.push_back(std::isfinite(arrival) ? arrival : -1.0);
    }

    // To where it is, by way of a checkpoint.
    void go_back() {
        const WorldCheckpoint taken = world_.checkpoint();
        // Keys alone: the numbers of a shape differ by rounding.
        const nlohmann::ordered_json flat = to_json(taken).flatten();
        for (const auto& [key, value] : flat.items()) checkpoints_ += key;
        world_.restore(taken);
    }

    Job job_;
    World world_;
    DeformPart& body_ = *world_.deform();
    FlowPart& flow_ = *world_.flow();
    const VesselTree& tree_ = small_patient()->tree;
    const Vec3 place_ = middle_of(tree_, 1), cut_ = middle_of(tree_, 0);
    Vec3 along_, across_;
    std::vector<double> shapes_, tools_, hand_, tears_, shown_tears_, crossings_, drug_;
    std::string checkpoints_;
};

TEST(SceneFigures, OfEverythingThatCanBeDone) {
    SceneSpec spec = default_scene();
    spec.contact = ContactSpec{.tools = true, .self = true};
    expect_recorded("scene", "handled", Handling(spec).figures());
    spec.tear = TearSpec{.tear_factor = 0.4, .stop = TearStop::entropy, .entropy_budget = 0.3};
    spec.contact->self = false;
    spec.deform->wall_mm = 0.8;
    expect_recorded("scene", "handled_tearing", Handling(spec).figures());
}

// Each is a scene with one thing wrong; what is said about it is for the person who wrote it.
TEST(SceneFigures, OfWhatIsSaidAboutWrongScenes) {
    using Json = nlohmann::ordered_json;
    std::string said;
    for (const char* text : {R"([])",
                             R"({"name": 3})",
                             R"({"name": "x"})",
                             R"({"flow": {}, "dt_s": 1.001})",
                             R"({"flow": {}, "tear": {}})",
                             R"({"flow": {}, "contact": {}})",
                             R"({"flow": {"drug_speed": 0.9e-6}})",
                             R"({"flow": {"drug_speed": 1.1e6}})",
                             R"({"deform": {"tether_pa_per_mm2": -0.001}})",
                             R"({"deform": {"tether_pa_per_mm2": 1.1e9}})",
                             R"({"deform": {"material": 1}})",
                             R"({"deform": {"gravity_mm_per_s2": [1, 2]}})",
                             R"({"deform": {"velocity_error": [1]}})",
                             R"({"deform": {"velocity_error": [0, 1e999]}})",
                             R"({"deform": {"fixed": "root"}})",
                             R"({"deform": {"quality": -0.1}})",
                             R"({"deform": {"setting": {"substeps": 65}}})",
                             R"({"deform": {"wall_mm": 0.001}})",
                             R"({"deform": {"walls_mm": 1}})",
                             R"({"deform": {}, "contact": {"walls": true}})",
                             R"({"deform": {}, "contact": {"tool": true}})",
                             R"({"deform": {}, "tear": {"tear_factor": 0.9e-6}})",
                             R"({"deform": {}, "tear": {"tear_factor": 1.1e9}})",
                             R"({"deform": {}, "tear": {"stop": "now"}})",
                             R"({"deform": {}, "tear": {"entropy_budget": -1e-9}})",
                             R"({"deform": {}, "tear": {"entropy_budget": 1.1e6}})",
                             R"({"deform": {}, "tear": {"vertex_budget": -1}})",
                             R"({"deform": {}, "tear": {"bare": true}})"}) {
        try {
            scene_from_json(Json::parse(text, nullptr, false));
            ADD_FAILURE() << text << " was read";
        } catch (const InputError& error) {
            said += error.problem() + "|" + error.place() + "|" + error.remedy() + "\n";
        }
    }
    expect_recorded("scene", "refusals", Figures().add("words", text_of(said)));
}

// What lies on its bounds is read, and written as it was.
TEST(SceneFigures, OfScenesOnTheirBounds) {
    using Json = nlohmann::ordered_json;
    std::string text;
    for (const char* scene :
         {R"({"flow": {"drug_speed": 1e-6}})", R"({"flow": {"drug_speed": 1e6}})",
          R"({"deform": {"tether_pa_per_mm2": 0, "wall_mm": 0.01, "fixed": "all"}})",
          R"({"deform": {"tether_pa_per_mm2": 1e9, "wall_mm": 100, "fixed": "none",
                         "velocity_error": [0, 0.001]}})",
          R"({"deform": {"velocity_error": [0.5, 0], "setting": {"substeps": 64,
                         "newton_iterations": 100, "max_iterations": 20000, "tension": false,
                         "energy_tolerance": 0, "published": true}}})",
          R"({"deform": {}, "contact": {"tools": true}, "tear": {"tear_factor": 1e-6,
              "stop": "entropy", "entropy_budget": 0, "vertex_budget": 0}})",
          R"({"deform": {}, "contact": {"self": true}, "tear": {"tear_factor": 1e9,
              "stop": "vertices", "entropy_budget": 1e6, "bare_limit": true}})",
          R"({"deform": {}, "contact": {}, "dt_s": 0.0001})"})
        text += to_json(scene_from_json(Json::parse(scene))).dump() + "\n";
    expect_recorded("scene", "bounds", Figures().add("text", text_of(text)));
}

// What a scene says without saying it, as its file has it.
TEST(SceneFigures, OfDefaults) {
    SceneSpec spec = default_scene();
    std::string text = to_json(spec).dump();
    spec.contact.emplace();
    spec.tear.emplace();
    text += to_json(spec).dump();
    text += to_json(scene_from_json(nlohmann::ordered_json::parse(R"({"flow": {}})"))).dump();
    text += to_json(scene_from_json(nlohmann::ordered_json::parse(
                        R"({"name": "x", "deform": {}, "contact": {}, "tear": {}, "flow": {}})")))
                .dump();
    expect_recorded("scene", "defaults", Figures().add("text", text_of(text)));
}

}  // namespace
}  // namespace hepatica
