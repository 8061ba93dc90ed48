// SPDX-License-Identifier: GPL-3.0-or-later
// A session in which vessels tear while a drug runs, or before.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/flow/injection.h"
#include "core/scene/bleeding.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/session/cut_vessel.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::blade;
using test::keep_recording;
using test::of_portal_veins;
using test::play;
using test::small_patient;

// The drug leaks once it has reached the stump, no faster than it is injected or the stump bleeds,
// goes into checkpoints, and lies where blood does; a reset takes it away.
TEST(TearSession, ADrugLeaksFromTheStumpThatItReaches) {
    const auto session = of_portal_veins();
    session->post(blade());
    InjectDrug drug;
    drug.point_mm = small_patient()->tree.segments[0].points_mm.front();
    drug.mass_flow_g_s = 2.0;
    drug.void_fraction = 0.0;
    session->post(drug);
    session->step();
    session->update_frame();
    EXPECT_GT(session->frame().tear->leaked_g, 0.0);
    EXPECT_EQ(session->frame().tear->leaked_drug_g, 0.0) << "it is not there yet";
    for (int i = 0; i < 1200 && session->frame().tear->leaked_drug_g == 0.0; ++i) {
        session->step();
        session->update_frame();
    }
    const Frame& frame = session->frame();
    ASSERT_GT(frame.tear->leaked_drug_g, 0.0);
    EXPECT_LE(frame.tear->leaked_drug_g, frame.tear->leaked_g);
    EXPECT_LE(frame.tear->leaked_drug_g, drug.mass_flow_g_s * frame.drug.time_s);
    double lying = 0.0;
    for (const LeakView& leak : frame.tear->leaks) lying += leak.drug_g;
    EXPECT_NEAR(lying, frame.tear->leaked_drug_g, 1e-12);
    const WorldCheckpoint kept = session->world().checkpoint();
    EXPECT_EQ(kept.leaked_drug_g, frame.tear->leaked_drug_g);
    EXPECT_EQ(world_checkpoint_from_json(to_json(kept)).leaked_drug_g, kept.leaked_drug_g);
    session->post(ResetWorld{});
    session->step();
    EXPECT_EQ(session->world().bleeding()->leaked_drug_g(), 0.0);
}

// What was injected before the tear ends there as well as what is injected after it.
TEST(TearSession, AnInjectionKnowsWhatIsTornByThen) {
    const auto session = of_portal_veins();
    InjectDrug drug;
    drug.point_mm = small_patient()->tree.segments[0].points_mm.front();
    drug.void_fraction = 0.0;
    const auto reached_behind = [&] {
        const FlowPart& flow = *session->world().flow();
        int behind = 0, reached = 0;
        for (std::size_t v = 0; v < session->world().vertex_count(); ++v) {
            if (flow.place_of(static_cast<int>(v)).segment == 0) continue;
            ++behind;
            reached += std::isfinite((*flow.drug().arrival_s)[v]) ? 1 : 0;
        }
        EXPECT_GT(behind, 100);
        return reached;
    };
    session->post(drug);
    session->step();
    EXPECT_GT(reached_behind(), 100);
    const int injections = session->world().flow()->drug().injections;
    session->post(blade());  // through the only vessel that supplies the others
    play(*session, 12);
    ASSERT_GT(session->world().bleeding()->leak_g_s(), 0.0);
    EXPECT_EQ(reached_behind(), 0) << "it is not there yet";
    EXPECT_EQ(session->world().flow()->drug().injections, injections);
    EXPECT_GT(session->world().flow()->drug().time_s, 12.5 * frame_s) << "its clock ran on";
    session->update_frame();
    EXPECT_FALSE(session->frame().drug.injection->later_tears.empty());
    session->post(drug);
    session->step();
    EXPECT_EQ(reached_behind(), 0);
    session->update_frame();
    EXPECT_FALSE(session->frame().drug.injection->tears.empty());
}

// A paused world makes no steps, after which the flow behind the tear would be shown.
TEST(TearSession, APauseBeforeTheFlowAfterATearIsShownIsRest) {
    const auto session = of_portal_veins();
    InjectDrug drug;
    drug.point_mm = small_patient()->tree.segments[0].points_mm.front();
    drug.void_fraction = 0.0;
    session->post(drug);
    session->step();
    session->post(blade());
    for (int i = 0; i < 12 && !session->world().flow()->computing(); ++i) session->step();
    ASSERT_TRUE(session->world().flow()->computing());
    session->post(SetPaused{true});
    session->step();
    session->step();
    session->update_frame();
    EXPECT_TRUE(session->frame().statistics.resting);
    EXPECT_TRUE(session->world().flow()->computing());
    session->post(SetPaused{false});
    play(*session, 8);
    EXPECT_FALSE(session->world().flow()->computing());
}

// As it is done where no window looks after ready injections.
TEST(TearSession, ADrugUnlikeBloodHearsOfATearWhereSomebodyAsks) {
    for (const bool asked : {false, true}) {
        const auto session = of_portal_veins();
        InjectDrug drug;
        drug.point_mm = small_patient()->tree.segments[0].points_mm.front();
        drug.void_fraction = 0.3;
        session->post(drug);
        session->post(FinishInjection{});
        session->step();
        session->post(blade());
        for (int i = 0; i < 12; ++i) {
            if (asked) session->finish_injection();
            session->step();
        }
        ASSERT_GT(session->world().bleeding()->leak_g_s(), 0.0);
        EXPECT_EQ(session->world().flow()->waits_for_finish(), !asked);
        session->update_frame();
        EXPECT_EQ(session->frame().drug.injection->later_tears.empty(), !asked);
    }
}

// From the start and from a keyframe behind the tear, at which the drug runs.
TEST(TearSession, ADrugThatATearStopsPlaysAgain) {
    const auto session = of_portal_veins();
    const auto recording = keep_recording(*session);
    play(*session, 570);
    InjectDrug drug;
    drug.point_mm = small_patient()->tree.segments[0].points_mm.front();
    drug.void_fraction = 0.0;
    session->post(drug);
    play(*session, 10);
    session->post(blade());
    play(*session, 40);  // over the keyframe at 600
    session->post(RestoreSnapshot{});
    play(*session, 5);
    ASSERT_FALSE(session->world().flow()->checkpoint().injected->later.empty());
    const auto patient = std::make_shared<const PatientCase>(session->world().patient());
    const auto file = std::filesystem::path(testing::TempDir()) / "a_drug_that_a_tear_stops.hrec";
    write_recording(file, *recording);
    const Recording read = read_recording(file);
    for (const std::uint64_t from : {std::uint64_t{0}, std::uint64_t{620}}) {
        Job job;
        const ReplayResult again = replay(read, patient, job, from);
        EXPECT_FALSE(again.diverged_at) << *again.diverged_at;
        EXPECT_EQ(again.state_hash, session->state_hash()) << "from " << from;
        EXPECT_EQ(again.began_at > 0, from > 0);
    }
}

}  // namespace
}  // namespace hepatica
