// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics against closed forms, on frames made by hand.
#include "core/lesson/play_meter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/scene/drug_arrival.h"
#include "tests/lesson/frames.h"

namespace hepatica {
namespace {

using test::plain_lesson;
using test::rest_frame;
using test::small_patient;
using test::touching;
using test::with_force;
using test::with_tip;

PlayMeter meter_of(const std::vector<Frame>& frames, const Lesson& lesson = plain_lesson()) {
    PlayMeter meter(lesson, small_patient());
    meter.begin(rest_frame());
    for (const Frame& frame : frames) meter.see(frame);
    return meter;
}

TEST(PlayMeter, TheTipsPathIsThePolylinesLength) {
    const PlayMeter meter =
        meter_of({with_tip({0, 0, 0}), with_tip({3, 4, 0}), with_tip({3, 4, 12}),
                  with_tip({3, 4, 12}), with_tip({0, 0, 12})});
    EXPECT_DOUBLE_EQ(meter.metrics().path_mm, 5.0 + 12.0 + 0.0 + 5.0);
    EXPECT_DOUBLE_EQ(meter.metrics().time_s, 2.5);
}

TEST(PlayMeter, AToolThatIsPutAwayAndTakenElsewhereHasGoneNoWay) {
    const PlayMeter meter =
        meter_of({with_tip({0, 0, 0}), with_tip({1, 0, 0}), rest_frame(), with_tip({90, 0, 0})});
    EXPECT_DOUBLE_EQ(meter.metrics().path_mm, 1.0);
}

TEST(PlayMeter, TheHandsPathIsThatOfItsTarget) {
    std::vector<Frame> frames(3, with_force(0.0));
    frames[1].grab->target_mm = Vec3(0, 2, 0);
    frames[2].grab->target_mm = Vec3(0, 2, -7);
    EXPECT_DOUBLE_EQ(meter_of(frames).metrics().path_mm, 9.0);
}

TEST(PlayMeter, AConstantForceForATimeHasTheirProduct) {
    const PlayMeter meter = meter_of(std::vector<Frame>(20, with_force(250e3)));
    EXPECT_DOUBLE_EQ(meter.metrics().impulse_mn_s, 250.0 * 10.0);
    EXPECT_DOUBLE_EQ(meter.metrics().peak_force_mn, 250.0);
    EXPECT_DOUBLE_EQ(meter_of({with_tip(Vec3::Zero(), {3e3, 0, 4e3})}).metrics().peak_force_mn,
                     5.0);
}

TEST(PlayMeter, ThePeakIsTheLargestAndTheMomentTheLast) {
    const PlayMeter meter = meter_of({with_force(1e3), with_force(9e3), with_force(2e3)});
    EXPECT_DOUBLE_EQ(meter.metrics().peak_force_mn, 9.0);
    EXPECT_DOUBLE_EQ(meter.moment().force_mn, 2.0);
}

// Where a vessel snaps, the force of one step is many times what a hand would feel.
TEST(PlayMeter, ForcesAreThoseAHandWouldFeelAndTheirIntegralIsExact) {
    Lesson lesson = plain_lesson();
    lesson.scene.dt_s = 0.1 * PlayMeter::felt_over_s;
    std::vector<Frame> frames(20, with_force(100e3));
    frames[15] = with_force(900e3);
    const PlayMeter meter = meter_of(frames, lesson);
    EXPECT_DOUBLE_EQ(meter.metrics().peak_force_mn, 180.0);
    EXPECT_DOUBLE_EQ(meter.moment().force_mn, 180.0) << "the jump is four steps old";
    EXPECT_NEAR(meter.metrics().impulse_mn_s, (19 * 100.0 + 900.0) * lesson.scene.dt_s, 1e-9);
}

// Half a second between frames is longer than what counts as the same contact.
TEST(PlayMeter, CountsEachTimeThatAToolBeginsToTouch) {
    const PlayMeter meter = meter_of({touching(true), touching(true), touching(false),
                                      touching(true), touching(false), touching(false)});
    EXPECT_EQ(meter.metrics().contacts, 2);
    EXPECT_DOUBLE_EQ(meter.metrics().contact_s, 1.5);
}

TEST(PlayMeter, AToolThatTrembleTouchesOnce) {
    Lesson lesson = plain_lesson();
    lesson.scene.dt_s = 0.25 * PlayMeter::same_contact_s;
    EXPECT_EQ(
        meter_of({touching(true), touching(false), touching(true)}, lesson).metrics().contacts, 1);
}

TEST(PlayMeter, WhatIsShownWhileTheClockIsHeldCountsForNothing) {
    Frame held = with_force(5e3);
    held.statistics.paused = true;
    EXPECT_EQ(meter_of({held, held}).metrics(), LessonMetrics{});
}

TEST(PlayMeter, AMarkIsInTheMiddleOfItsVesselAndMovesWithIt) {
    Lesson lesson = plain_lesson();
    const Vec3 place = test::middle_of(small_patient()->tree, 0);
    lesson.marks.push_back({"mark", {.point_mm = place}});
    Frame moved = with_tip(Vec3(1000, 0, 0));
    for (std::size_t i = 2; i < moved.positions_mm.size(); i += 3) moved.positions_mm[i] += 6.0f;
    const PlayMeter meter = meter_of({moved}, lesson);
    EXPECT_NEAR((meter.marks_in(rest_frame())[0] - place).norm(), 0.0, 1.0)
        << "of a radius of 4 mm";
    EXPECT_NEAR(meter.moment().marks[0].moved_mm, 6.0, 1e-4);
    const Vec3 tip(1000, 0, 0), mark = meter.marks_in(rest_frame())[0] + Vec3(0, 0, 6);
    EXPECT_NEAR(meter.moment().marks[0].distance_mm, (tip - mark).norm(), 1e-3);
    EXPECT_TRUE(std::isinf(meter.moment().marks[0].touch_mm)) << "it touches nothing";
}

// Where jaws touch is that of whichever vessel lies in their way.
TEST(PlayMeter, AMarksDistanceOfTheTouchIsThatOfTheMiddleOfJaws) {
    Lesson lesson = plain_lesson();
    lesson.marks.push_back({"mark", {.share_of_longest_path = 0.5}});
    const Vec3 mark = PlayMeter(lesson, small_patient()).marks_in(rest_frame())[0];
    Frame touching = with_tip(mark + Vec3(0, 5, 0));
    ToolView& tool = *touching.tool;
    tool.touched = {0};
    tool.at_mm = mark + Vec3(0, 0, 30);
    const auto touch_mm = [&] { return meter_of({touching}, lesson).moment().marks[0].touch_mm; };
    tool.parts = {{tool.tip_mm - Vec3(0, 20, 0), tool.tip_mm, 1.0}};
    EXPECT_NEAR(touch_mm(), 30.0, 1e-3) << "a rod";
    const Vec3 aside(4, 0, 0), along(0, 12, 0);
    tool.parts = {{tool.tip_mm - aside - along, tool.tip_mm - aside, 1.0},
                  {tool.tip_mm + aside - along, tool.tip_mm + aside, 1.0}};
    EXPECT_NEAR(touch_mm(), 2.0, 1e-3) << "a quarter of their length from their tips";
    // Every vertex, that of the mark among them.
    tool.touched.resize(small_patient()->mesh.vertices_mm.size());
    std::iota(tool.touched.begin(), tool.touched.end(), 0);
    const auto distance_mm = [&] {
        return meter_of({touching}, lesson).moment().marks[0].distance_mm;
    };
    EXPECT_NEAR(distance_mm(), 2.0, 1e-3) << "as the picture says";
    tool.parts.pop_back();
    EXPECT_EQ(distance_mm(), 0.0) << "a rod has arrived";
    tool.touched.clear();
    EXPECT_TRUE(std::isinf(touch_mm()));
}

// A segment far off has no vertices of its own.
TEST(PlayMeter, AMarkOnASegmentWithoutSurfaceIsAtTheNearestVertex) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    const Vec3 end = patient->tree.nodes.back().position_mm;
    const Vec3 place = end + 20.0 * (end - patient->tree.nodes.front().position_mm);
    VesselSegment far;
    far.proximal_node = static_cast<int>(patient->tree.nodes.size());
    far.distal_node = far.proximal_node + 1;
    far.points_mm = {place, place + Vec3(1, 0, 0)};
    far.radii_mm = {0.5, 0.5};
    for (const Vec3& p : far.points_mm) patient->tree.nodes.push_back({p, 0.5});
    patient->tree.segments.push_back(far);
    Lesson lesson = plain_lesson();
    lesson.marks.push_back({"far", {.point_mm = place}});
    double least_mm = 1e9;
    for (const std::array<int, 3>& t : *rest_frame().surface)
        for (const int v : t)
            least_mm = std::min(least_mm, (patient->mesh.vertices_mm[v] - place).norm());
    const PlayMeter meter(lesson, patient);
    EXPECT_NEAR((meter.marks_in(rest_frame())[0] - place).norm(), least_mm, 1e-3);
}

TEST(PlayMeter, TearsCountFromTheBeginningOn) {
    Frame before = rest_frame();
    before.tear.emplace();
    before.tear->joints_broken = 4;
    before.tear->torn_area_mm2 = 12.0;
    before.tear->pieces = 2;
    before.tear->leaked_g = 0.5;
    before.tear->leak_g_s = 3.0;
    PlayMeter meter(plain_lesson(), small_patient());
    meter.begin(before);
    EXPECT_EQ(meter.moment().leak_g_s, 3.0);
    Frame later = before;
    later.tear->joints_broken = 9;
    later.tear->torn_area_mm2 = 20.0;
    later.tear->pieces = 3;
    later.tear->leaked_g = 2.0;
    meter.see(later);
    EXPECT_EQ(meter.metrics().joints_broken, 5);
    EXPECT_DOUBLE_EQ(meter.metrics().torn_area_mm2, 8.0);
    EXPECT_EQ(meter.metrics().pieces_off, 1);
    EXPECT_DOUBLE_EQ(meter.metrics().blood_lost_g, 1.5);
    meter.see(before);
    EXPECT_EQ(meter.metrics().joints_broken, 5) << "what was torn stays torn in the score";
}

// Vessels that lie apart from the start have not come off, though tearing begins in mid-play.
TEST(PlayMeter, WhatWasApartBeforeTearingBeganIsNoPieceOff) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    Frame frame = rest_frame();
    TetMesh& mesh = patient->mesh;
    const int count = static_cast<int>(mesh.vertices_mm.size());
    const auto vertices = mesh.vertices_mm;
    const auto tetrahedra = mesh.tetrahedra;
    const auto positions = frame.positions_mm;
    for (const Vec3& vertex : vertices) mesh.vertices_mm.push_back(vertex + Vec3(500, 0, 0));
    for (std::array<int, 4> corners : tetrahedra) {
        for (int& corner : corners) corner += count;
        mesh.tetrahedra.push_back(corners);
    }
    frame.positions_mm.insert(frame.positions_mm.end(), positions.begin(), positions.end());
    PlayMeter meter(plain_lesson(), patient);
    meter.begin(frame);
    frame.tear.emplace();
    frame.tear->pieces = 2;
    meter.see(frame);
    EXPECT_EQ(meter.metrics().pieces_off, 0);
    frame.tear->pieces = 3;
    meter.see(frame);
    EXPECT_EQ(meter.metrics().pieces_off, 1);
}

// A play into which a drug flows that comes to about a third of the vertices at 1 s, to a third at
// 5 s, and practically never to the others.
class DrugByThirds {
  public:
    DrugByThirds() { meter_.begin(rest_frame()); }
    // `before`: the thirds that injections before this one have reached.
    void show(std::size_t early, std::size_t late, std::vector<std::size_t> before = {}) {
        auto times = std::make_shared<std::vector<float>>();
        auto reached = std::make_shared<std::vector<std::uint8_t>>();
        for (std::size_t v = 0; v < small_patient()->mesh.vertices_mm.size(); ++v) {
            const std::size_t kind = ((v * 37) % 101) % 3;
            times->push_back(kind == early ? 1.0f : kind == late ? 5.0f : 1e9f);
            reached->push_back(std::ranges::find(before, kind) != before.end() ? 1 : 0);
        }
        take_out();
        frame_.drug.arrival_s = times;
        if (!before.empty()) frame_.drug.reached_before = reached;
    }
    void take_out() {
        frame_.drug = {};
        frame_.drug.version = ++version_;
    }
    std::array<double, 2> filled_at(double time_s) {
        frame_.drug.time_s = time_s;
        meter_.see(frame_);
        return {meter_.moment().target_filled, meter_.moment().elsewhere_filled};
    }
    const PlayMeter& meter() const { return meter_; }

  private:
    static Lesson lesson_with_target() {
        Lesson lesson = plain_lesson();
        lesson.scene.flow.emplace();
        lesson.target = {{std::nullopt, 0.5}};
        return lesson;
    }
    PlayMeter meter_{lesson_with_target(), small_patient()};
    Frame frame_ = rest_frame();
    std::uint64_t version_ = 0;
};

constexpr std::array nowhere{0.0, 0.0};

// What an injection has reached stays reached when another takes its place, until the drug is taken
// out. The frame says what that is, so that nothing else has to be known of the play before it.
TEST(PlayMeter, WhatTheDrugHasReachedStaysReachedThroughAllInjections) {
    DrugByThirds play;
    play.show(0, 1);
    const auto first = play.filled_at(2.0);
    for (const double share : first) EXPECT_GT(share, 0.1);
    play.show(2, 1, {0});
    EXPECT_EQ(play.filled_at(0.5), first) << "the second has reached nothing yet";
    const auto both = play.filled_at(2.0);
    for (std::size_t i = 0; i < both.size(); ++i) EXPECT_GT(both[i], first[i] + 0.1);
    play.show(1, 0, {0, 2});
    EXPECT_EQ(play.filled_at(0.5), both);
    play.take_out();
    EXPECT_EQ(play.filled_at(0.0), nowhere) << "taken out";
    EXPECT_FALSE(play.meter().moment().drug_present);
    play.show(0, 1);
    EXPECT_EQ(play.filled_at(2.0), first) << "what was taken out does not count again";
}

TEST(PlayMeter, WhatWasReachedBeforeTheFirstFrameOfThePlayCounts) {
    DrugByThirds whole, begun;
    whole.show(0, 1);
    const auto first = whole.filled_at(2.0);
    begun.show(2, 1, {0});
    EXPECT_EQ(begun.filled_at(0.5), first);
}

TEST(PlayMeter, WhereThePlayGoesBackTheDrugHasReachedWhatItHadThen) {
    DrugByThirds play;
    play.show(0, 1);
    const auto first = play.filled_at(2.0);
    EXPECT_GT(first[0], 0.1);
    play.show(0, 1);
    EXPECT_EQ(play.filled_at(0.5), nowhere) << "back before it had come anywhere";
    play.show(2, 1);
    EXPECT_EQ(play.filled_at(0.5), nowhere);
    EXPECT_GT(play.filled_at(2.0)[0], 0.1);
    play.show(0, 1);
    EXPECT_EQ(play.filled_at(2.0), first) << "the second is undone";
}

// A vertex that is split gives the drug's times a new version, too.
TEST(PlayMeter, WhereTheDrugsClockIsSetBackASplitVertexKeepsNothingReached) {
    DrugByThirds play;
    play.show(0, 1);
    EXPECT_GT(play.filled_at(2.0)[0], 0.1);
    EXPECT_EQ(play.filled_at(0.5), nowhere);
    EXPECT_GT(play.filled_at(2.0)[0], 0.1);
    play.show(0, 1);
    EXPECT_EQ(play.filled_at(0.5), nowhere);
}

// A wide vessel's middle is farther from its surface than what counts as near.
TEST(PlayMeter, WhoTouchesTheVesselAtTheMarkIsNear) {
    Lesson lesson = plain_lesson();
    lesson.marks = {{"there", {std::nullopt, 0.5}}};
    PlayMeter meter(lesson, small_patient());
    meter.begin(rest_frame());
    const Vec3 mark = meter.marks_in(rest_frame()).at(0);
    Frame frame = with_tip(mark + Vec3(40, 0, 0));
    int nearest = 0;
    double least = 1e9;
    for (const std::array<int, 3>& t : *frame.surface)
        for (const int v : t) {
            const double distance = (small_patient()->mesh.vertices_mm[v] - mark).norm();
            if (distance < least) nearest = v;
            least = std::min(least, distance);
        }
    frame.tool->at_mm = frame.tool->tip_mm;
    meter.see(frame);
    EXPECT_NEAR(meter.moment().marks.at(0).distance_mm, 40.0, 1e-3);
    frame.tool->touched = {nearest};
    meter.see(frame);
    EXPECT_EQ(meter.moment().marks.at(0).distance_mm, 0.0);
}

// A pump that stands ends the injection; taking the drug out also empties the target.
TEST(PlayMeter, AStoppedInjectionLeavesTheTargetFilled) {
    Lesson lesson = plain_lesson();
    lesson.scene.flow.emplace();
    lesson.target = ScriptPlace{.share_of_longest_path = 0.6};
    Frame frame = rest_frame();
    frame.drug.injection = std::make_shared<const InjectionOptions>(
        injection_options({.at = {0, 20.0}, .mass_flow_g_s = 4.0}, small_patient()->tree));
    frame.drug.arrival_s =
        std::make_shared<const std::vector<float>>(small_patient()->mesh.vertices_mm.size(), 1.0F);
    frame.drug.version = 1;
    frame.drug.end_s = 15.0;
    frame.drug.time_s = 2.0;
    PlayMeter meter(lesson, small_patient());
    meter.begin(rest_frame());
    const auto expect = [&](bool runs, double filled) {
        meter.see(frame);
        EXPECT_EQ(meter.moment().drug_present, runs);
        EXPECT_EQ(meter.moment().target_filled, filled);
    };
    frame.drug.playing = true;
    expect(true, 1.0);
    frame.drug.playing = false;
    expect(false, 1.0);
    frame.drug = {};
    expect(false, 0.0);
}

}  // namespace
}  // namespace hepatica
