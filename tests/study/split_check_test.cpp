// SPDX-License-Identifier: GPL-3.0-or-later
// That the checks of a split see what they are there for.
#include "core/study/split_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"
#include "core/study/forwarding_back_end.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

// Two tetrahedra across a face.
TetMesh pair() {
    TetMesh mesh;
    mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}, {4, 2, 1, 3}};
    return mesh;
}

TEST(SplitCheck, TetrahedraMustHangTogetherByFaces) {
    TetMesh mesh = pair();
    EXPECT_TRUE(fans_connected(mesh));
    mesh.vertices_mm.push_back({1, 0, 0});
    mesh.tetrahedra[1] = {4, 2, 5, 3};  // by an edge
    EXPECT_FALSE(fans_connected(mesh));
    mesh.vertices_mm.push_back({0, 1, 0});
    mesh.tetrahedra[1] = {4, 6, 5, 3};  // by a point
    EXPECT_FALSE(fans_connected(mesh));
    mesh.vertices_mm.push_back({0, 0, 1});
    mesh.tetrahedra[1] = {4, 6, 5, 7};  // not at all
    EXPECT_TRUE(fans_connected(mesh));
}

// A torn body is well formed where its topology tells the surface that it has.
std::string fault_of(const TetMesh& mesh) {
    return fault_of_shape(mesh, boundary_triangles(mesh));
}

TEST(SplitCheck, AShapeThatIsWrongIsNamed) {
    EXPECT_EQ(fault_of(pair()), "");
    TetMesh lost = pair();
    lost.vertices_mm[2].y() = std::numeric_limits<double>::infinity();
    EXPECT_THAT(fault_of(lost), testing::HasSubstr("not finite"));
    TetMesh hanging = pair();
    hanging.vertices_mm.push_back({1, 0, 0});
    hanging.tetrahedra[1] = {4, 2, 5, 3};
    EXPECT_THAT(fault_of(hanging), testing::HasSubstr("by a point or an edge"));
    TetMesh turned = pair();  // one is left-handed, so that both see their common face alike
    std::swap(turned.tetrahedra[1][0], turned.tetrahedra[1][1]);
    EXPECT_THAT(fault_of(turned), testing::HasSubstr("is not closed at the edge"));
    auto told = boundary_triangles(pair());
    std::rotate(told[0].begin(), told[0].begin() + 1, told[0].end());
    EXPECT_EQ(fault_of_shape(pair(), told), "");  // the same surface
    std::swap(told[0][0], told[0][1]);
    EXPECT_THAT(fault_of_shape(pair(), told), testing::HasSubstr("another surface"));
    told = boundary_triangles(pair());
    told.pop_back();
    EXPECT_THAT(fault_of_shape(pair(), told), testing::HasSubstr("another surface"));
}

// Four masses of 1 g at rest or on their way, before and after.
SplitMoment moment() {
    SplitMoment one;
    one.before.positions_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    one.before.velocities_mm_per_s.assign(4, Vec3(1, 2, 3));
    one.after = one.before;
    one.mass_before_g = one.mass_after_g = {1, 1, 1, 1};
    return one;
}

TEST(SplitCheck, EachQuantityThatASplitChangesIsNamed) {
    EXPECT_EQ(fault_of_motion(moment()), "");
    SplitMoment heavier = moment();
    heavier.mass_after_g[2] += 1e-9;
    EXPECT_EQ(fault_of_motion(heavier), "mass changed");
    SplitMoment turned_back = moment();  // as fast as before
    for (Vec3& v : turned_back.after.velocities_mm_per_s) v = -v;
    EXPECT_EQ(fault_of_motion(turned_back), "momentum changed");
    SplitMoment shifted = moment();
    for (Vec3& x : shifted.after.positions_mm) x.y() += 1e-9;
    EXPECT_EQ(fault_of_motion(shifted), "angular momentum changed");
    SplitMoment spread = moment();  // at one place, where no spin tells
    spread.before.positions_mm.assign(4, Vec3(1, 1, 1));
    spread.after.positions_mm = spread.before.positions_mm;
    spread.after.velocities_mm_per_s[0].x() += 0.1;
    spread.after.velocities_mm_per_s[1].x() -= 0.1;
    EXPECT_EQ(fault_of_motion(spread), "kinetic energy changed");
    SplitMoment unknown = moment();
    unknown.mass_after_g[0] = std::nan("");
    EXPECT_EQ(fault_of_motion(unknown), "mass changed");
}

// Does something wrong to the state, or to the masses, whenever the body is torn.
struct Fault {
    std::function<void(BodyState&)> of_state{};
    std::function<void(std::vector<double>&)> of_mass{};
};

class FaultyBackEnd final : public ForwardingBackEnd {
  public:
    FaultyBackEnd(std::unique_ptr<StepBackEnd> good, Fault fault)
        : ForwardingBackEnd(std::move(good)), fault_(std::move(fault)) {}

    const Body& body() const override { return torn_ ? *torn_ : ForwardingBackEnd::body(); }
    void tear(const BodyDescription& whole, const TornBody& tear) override {
        ForwardingBackEnd::tear(whole, tear);
        if (fault_.of_mass) {
            torn_ = ForwardingBackEnd::body();
            fault_.of_mass(torn_->mass_g);
        }
        if (!fault_.of_state) return;
        BodyState state = this->state();
        fault_.of_state(state);
        set_state(state);
    }

  private:
    Fault fault_;
    std::optional<Body> torn_;
};

// A bar that flies and turns.
class FlyingBar : public testing::Test {
  protected:
    FlyingBar() {
        body_.mesh = kuhn_brick(Vec3(8, 2, 2), {8, 2, 2});
        body_.fixed.assign(body_.mesh.vertices_mm.size(), 0);
        body_.tear.emplace();
        body_.density_factor.assign(body_.mesh.tetrahedra.size(), 1.0);
        body_.density_factor[7] = 3.0;
    }

    void begin(const Fault& fault = {}) {
        const auto make = [fault](const BodyDescription& body, const StepperOptions& options) {
            return std::make_unique<FaultyBackEnd>(make_cpu_back_end(body, options), fault);
        };
        check_.emplace(body_, StepperOptions{}, make);
        stepper_ = check_->make_stepper();
        std::vector<Vec3> velocities(body_.mesh.vertices_mm.size());
        for (std::size_t v = 0; v < velocities.size(); ++v)
            velocities[v] = Vec3(5, 0, 0) + Vec3(0, 0, 3).cross(body_.mesh.vertices_mm[v]);
        stepper_->set_state(body_.mesh.vertices_mm, velocities);
    }
    void cut() { stepper_->cut(Vec3(4.1, -1, -1), Vec3(0, 4, 0), Vec3(0, 0, 4)); }

    // What is said of a cut with this fault.
    std::string said_of(const Fault& fault) {
        begin(fault);
        EXPECT_EQ(check_->after_step(*stepper_), "");
        EXPECT_EQ(check_->splits(), 0);
        cut();
        const std::string said = check_->after_step(*stepper_);
        EXPECT_EQ(check_->splits(), 1);
        return said;
    }

    BodyDescription body_;
    std::optional<SplitCheck> check_;
    std::unique_ptr<Stepper> stepper_;
};

TEST_F(FlyingBar, WhatIsCutCleanlyHoldsAndIsCountedOnce) {
    EXPECT_EQ(said_of({}), "");
    EXPECT_EQ(check_->after_step(*stepper_), "");
    EXPECT_EQ(check_->splits(), 1);
    EXPECT_EQ(check_->with_inverted(), 0);
    EXPECT_EQ(check_->with_touching_edges(), 0);
}

TEST_F(FlyingBar, HasTheBitsOfAStepperThatNobodyWatches) {
    begin();
    const auto other = make_cpu_stepper(body_, {});
    other->set_state(stepper_->positions_mm(), stepper_->velocities_mm_per_s());
    for (Stepper* one : {stepper_.get(), other.get()}) {
        one->cut(Vec3(4.1, -1, -1), Vec3(0, 4, 0), Vec3(0, 0, 4));
        for (int k = 0; k < 3; ++k) one->step(0.01);
    }
    EXPECT_EQ(stepper_->state_hash(), other->state_hash());
}

// Faults of the whole body, that no comparison of new vertices with those that they come from sees.
TEST_F(FlyingBar, ASplitThatMovesTheWholeBodyIsSeen) {
    const auto all = [](const std::function<void(Vec3&, Vec3&)>& change) -> Fault {
        return {.of_state = [change](BodyState& state) {
            for (std::size_t v = 0; v < state.positions_mm.size(); ++v)
                change(state.positions_mm[v], state.velocities_mm_per_s[v]);
        }};
    };
    EXPECT_EQ(said_of(all([](Vec3& x, Vec3&) { x.x() += 1e-9; })), "a split moved a vertex");
    EXPECT_EQ(said_of(all([](Vec3&, Vec3& v) { v = -v; })), "a split changed a velocity");
    EXPECT_EQ(said_of(all([](Vec3&, Vec3& v) { std::swap(v.x(), v.y()); })),
              "a split changed a velocity");
    EXPECT_EQ(said_of(all([](Vec3&, Vec3& v) { v *= 1.0 + 1e-12; })), "a split changed a velocity");
}

TEST_F(FlyingBar, ANewVertexThatIsElsewhereIsSeen) {
    EXPECT_EQ(said_of({.of_state = [](BodyState& s) { s.positions_mm.back().x() += 1e-9; }}),
              "a vertex does not lie where it was split from");
    EXPECT_EQ(said_of({.of_state = [](BodyState& s) { s.velocities_mm_per_s.back().y() += 0.01; }}),
              "a vertex does not move as the one does that it was split from");
}

TEST_F(FlyingBar, MassThatASplitPutsElsewhereIsSeen) {
    const auto shared = [](std::vector<double>& mass_g) {  // of new and old vertices at one place
        mass_g.back() *= 1.01;
        mass_g[0] -= mass_g.back() - mass_g.back() / 1.01;
    };
    EXPECT_EQ(said_of({.of_mass = shared}), "a vertex has not the mass of its tetrahedra");
    EXPECT_EQ(said_of({.of_mass = [](std::vector<double>& mass_g) { mass_g[3] *= 1.0 + 1e-11; }}),
              "a vertex has not the mass of its tetrahedra");
}

TEST_F(FlyingBar, WhatIsChangedBehindASplitIsSeen) {
    begin();
    cut();
    BodyState state = stepper_->state();
    state.velocities_mm_per_s[0] *= 2.0;
    stepper_->set_state(state.positions_mm, state.velocities_mm_per_s);
    EXPECT_EQ(check_->after_step(*stepper_), "what a split left was changed in the same step");
}

// Energies that the back end tells too low before a split are as good as ones that it makes.
class ForgetfulBackEnd final : public ForwardingBackEnd {
  public:
    using ForwardingBackEnd::ForwardingBackEnd;
    EnergyLedger energies() const override {
        EnergyLedger now = ForwardingBackEnd::energies();
        if (!torn_) now.kinetic *= 0.99;
        return now;
    }
    void tear(const BodyDescription& whole, const TornBody& tear) override {
        ForwardingBackEnd::tear(whole, tear);
        torn_ = true;
    }

  private:
    bool torn_ = false;
};

TEST_F(FlyingBar, EnergyThatASplitMakesIsSeen) {
    SplitCheck check(body_, {}, [](const BodyDescription& body, const StepperOptions& options) {
        return std::make_unique<ForgetfulBackEnd>(make_cpu_back_end(body, options));
    });
    stepper_ = check.make_stepper();
    stepper_->set_state(body_.mesh.vertices_mm,
                        std::vector<Vec3>(body_.mesh.vertices_mm.size(), Vec3(5, 0, 0)));
    cut();
    EXPECT_THAT(check.after_step(*stepper_), testing::HasSubstr("a split made energy"));
}

TEST_F(FlyingBar, WhatIsInsideOutIsCounted) {
    begin();
    BodyState state = stepper_->state();
    state.positions_mm[0] += Vec3(3, 3, 3);
    stepper_->set_state(state.positions_mm, state.velocities_mm_per_s);
    cut();
    EXPECT_EQ(check_->after_step(*stepper_), "");
    EXPECT_EQ(check_->with_inverted(), 1);
}

// Cuts through each other leave wedges that share an edge and hang together elsewhere.
TEST_F(FlyingBar, ASurfaceThatTouchesItselfAlongAnEdgeIsCounted) {
    begin();
    std::mt19937 random(1);
    const auto place = [&](double most) {
        return most * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    for (int cuts = 0; cuts < 40 && check_->with_touching_edges() == 0; ++cuts) {
        const Vec3 corner(place(8), place(2), place(2));
        const Vec3 edge(place(2), place(2), place(2)), other(place(2), -place(2), place(2));
        stepper_->cut(corner, edge, other);
        EXPECT_EQ(check_->after_step(*stepper_), "");
    }
    EXPECT_EQ(check_->with_touching_edges(), 1);
}

}  // namespace
}  // namespace hepatica
