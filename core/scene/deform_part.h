// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world that moves: the body, its fixed ends, the hand that holds it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/frame.h"
#include "core/scene/pressed_stretches.h"
#include "core/scene/scene_spec.h"
#include "core/scene/through_tears.h"
#include "core/scene/tools/tool_choice.h"
#include "core/scene/vertex_places.h"
#include "core/scene/weak_edges.h"

namespace hepatica {

// What a person chooses of the body while it plays.
struct DeformSettings {
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
    double tether_pa_per_mm2 = 0.0;
    double wall_mm = 0.0;
    StepperOptions stepper;
    bool touchable = false;  // what tools need is built
    std::optional<TearSpec> tear{};
    std::optional<double> self_friction{};  // of vessels that touch each other; none: they do not
    bool obstacles = false;                 // stand in the way
};

// The hand, closed around some vertices.
struct Hold {
    std::vector<int> vertices;
    std::vector<Vec3> offsets_mm;  // from the held point, when the hand closed
    Vec3 target_mm = Vec3::Zero();
    double stiffness_un_per_mm = 0.0;  // of each spring
    double force_limit_un = 0.0;       // of each spring
};

// All that determines the part's steps to come, apart from the case and the scene's spec.
struct DeformCheckpoint {
    DeformSettings settings;
    std::optional<Hold> hold;
    StepperCheckpoint stepper;
};

class DeformPart {
  public:
    // Tissue makes a pull fade along the vessel, so that most of the tree may rest. Chosen by
    // `bench region` (docs/solver.md): a quarter of a millimetre off at most for a pull by two.
    static constexpr LiveRegionOptions region{.wake_radii = 3e-3, .still_radii_per_s = 1.5e-2};

    // With the spec's setting, or else the one at its quality on the patient's dial. Throws
    // InputError where the case has no mesh, the material is not known, or a value is out of range.
    // Another region is for measurements: nothing freezes where still_radii_per_s is 0. Tools may
    // be had, and vessels touch each other, where `contact` says so, and obstacles where some are
    // given; they tear where `tear` does.
    DeformPart(const PatientCase& patient, const DeformSpec& spec,
               const LiveRegionOptions& live_region = region,
               DeformBackEnd back_end = cpu_back_end(),
               const std::optional<ContactSpec>& contact = {},
               const std::optional<TearSpec>& tear = {},
               std::shared_ptr<const Obstacles> obstacles = {});
    ~DeformPart();

    // The hand closes around the point of the surface nearest to point_mm: every vertex within
    // about a radius is pulled by a spring, all together as stiff as the vessel is there.
    void grab(const Vec3& point_mm);
    void grab_vertex(int vertex);  // throws InputError if there is no such vertex
    void move_grab(const Vec3& target_mm);
    void release();
    // A tool comes in its direction towards a point, from outside, until it is about to touch
    // something or has its tip there. Takes the place of one that is there. Throws InputError
    // where the scene has none, for values out of range, and where there is no room.
    void add_tool(const ToolChoice& choice, const Vec3& towards_mm);
    // Where its centre is led to from the next step on. Without a tool it does nothing.
    void lead_tool(const Vec3& target_mm) { stepper_->lead_tool(target_mm); }
    // How far it is to turn about its centre beside what is left of earlier turns.
    void turn_tool(const Vec3& by_rad) { stepper_->turn_tool(by_rad); }
    // Jaws are led a share of the way from how far they are to open now: to 0, or to the widest.
    // Throws InputError for a tool without jaws; without a tool it does nothing.
    void close_jaws(double share) { lead_jaws(false, share); }
    void open_jaws(double share) { lead_jaws(true, share); }
    void remove_tool() { stepper_->set_tool(std::nullopt); }
    const std::optional<Tool>& tool() const { return stepper_->tool(); }
    std::optional<ToolView> tool_view() const;

    // How it tears; none: it does not, and is made whole. Throws InputError for values out of
    // range, and where the present setting's elements or solver cannot.
    void set_tear(const std::optional<TearSpec>& tear);
    bool tears() const { return tear_.has_value(); }
    int pieces() const;  // of a body that tears
    // The opening at which what has parted there has come apart; 0 where nothing can tear.
    double critical_opening_mm() const;
    // Where the tool presses on which vessel.
    std::vector<PressedStretch> pressed() const;
    // Where it is torn through.
    std::vector<ThroughTear> torn_through(const VesselTree& tree);
    // |mass of the torn body - mass of the whole| over that.
    double mass_error_relative() const;
    // Counts, entropy, what is near its limit; of a view that has origins its rims, too.
    void show_tear(TearView& view) const;
    // Null where it does not tear.
    const TornTopology* torn() const;
    // Lowers the strength along the way on the tree between the places that the two points are
    // nearest to, see joints_along. A strength of 0 to 1 of what it was. Throws InputError where
    // the body does not tear, where no way leads from one to the other, and for values out of
    // range.
    void cut_line(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm, double strength);
    // Leads a blade through the vessel nearest to its way, see blade_sweep. Throws InputError where
    // the body does not tear or the way is not finite.
    void cut(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm);
    // Whole again, without cut lines.
    void mend();

    bool holding() const { return hold_.has_value(); }
    const Vec3& hand_mm() const { return hold_->target_mm; }  // only while it is holding
    std::optional<GrabView> grab_view() const;

    // Settings that keep the state. Throw InputError for values out of range. Where they throw
    // anything, setting and state are as before.
    void set_gravity(const Vec3& gravity_mm_per_s2);
    void set_tether(double pa_per_mm2);
    void set_wall(double wall_mm);  // see DeformSpec
    // Builds what tools need, or lets go of it together with a tool that is there.
    void set_touchable(bool touchable);
    bool touchable() const { return body_.touchable; }
    // What the vessels touch from now on: each other, rubbing by Coulomb's coefficient, and these
    // obstacles; none of them: nothing. Where that is another than before, the body is at rest and
    // whole again, without hand and tool. Throws InputError for a coefficient out of range.
    void set_contact(const std::optional<double>& self_friction,
                     std::shared_ptr<const Obstacles> obstacles);
    void use(const StepperOptions& setting);
    const StepperOptions& setting() const { return setting_; }
    // The device that makes the steps now; empty: the processor does.
    std::string device() const { return stepper_->on_device() ? back_end_.device : ""; }
    DeformSettings settings() const;
    // Settings that are already in force cost nothing and do not change the bits of later steps.
    // `obstacles`: those that are meant where the settings want some; null: the present ones.
    void use(const DeformSettings& settings, std::shared_ptr<const Obstacles> obstacles = {});

    // As Stepper::step: after Cancelled only restore() may be called before another step.
    StepReport step(double dt_s, const std::stop_token& stop = {});
    std::span<const Vec3> positions_mm() const { return stepper_->positions_mm(); }
    std::span<const Vec3> velocities_mm_per_s() const { return stepper_->velocities_mm_per_s(); }
    // Vertices that were split off lie at rest where those do that they come from.
    const std::vector<Vec3>& rest_positions_mm() const { return rest_mm_; }
    const BodyDescription& body() const { return body_; }  // as built from the case: whole
    TetMesh shape() const;                                 // as it is now, torn
    // What a snapshot keeps: every node of the present element, the vertices first. A state of
    // another element is taken over by its vertices.
    BodyState state() const { return stepper_->state(); }
    void set_state(const BodyState& state) { give_state(*stepper_, state); }

    // Costs a copy of a few arrays.
    DeformCheckpoint checkpoint() const;
    // Goes on with the same bits as the part that the checkpoint was taken from, on the same case
    // and spec. Costs a factorisation. `obstacles` as use() has them. Throws InputError where it is
    // not of this body.
    void restore(const DeformCheckpoint& checkpoint,
                 std::shared_ptr<const Obstacles> obstacles = {});
    // Of all that a checkpoint holds: equal hashes, equal steps to come.
    std::uint64_t state_hash() const;

    const std::vector<VertexPlace>& places() const { return places_; }

    // False where a position is not finite or further from its place at rest than ten times the
    // body's size.
    bool plausible() const;

  private:
    void lead_jaws(bool open, double share);
    std::optional<TearLaw> law_of(const std::optional<TearSpec>& tear) const;
    std::shared_ptr<const std::vector<float>> vertex_loads() const;
    const std::vector<VertexPlace>& places_of_tetrahedra(const VesselTree& tree);
    void require_tear() const;
    int vertex_near(const Vec3& point_mm) const;
    Vec3 axis_near(const VertexPlace& place) const;
    // What is kept per vertex grows and shrinks with the body.
    void follow_tear();
    void give_state(Stepper& stepper, const BodyState& state) const;
    void fix_ends(const VesselTree& tree, FixedEnds ends);
    // Around the place of a vertex; the held point is where the hand is.
    void close_hand(int vertex, const Vec3& point_mm);
    // What a hand or a tool presses or pulls with at most, over the section of what it holds. Where
    // the vessel may tear it is strong enough for that.
    double hand_pressure_pa() const;
    static std::vector<Grab> springs_of(const std::optional<Hold>& hold);
    // The hand is as before where the stepper refuses it.
    void set_hold(std::optional<Hold> hold);
    // Goes on from the present state with another body or setting.
    void rebuild(BodyDescription body, const StepperOptions& setting);

    LiveRegionOptions region_;
    DeformBackEnd back_end_;
    BodyDescription body_;
    std::uint64_t obstacles_hash_ = 0;
    std::vector<int> surface_vertices_;
    std::vector<VertexPlace> places_;        // per vertex
    mutable std::vector<double> areas_mm2_;  // of the surface at rest, likewise, once asked for
    StepperOptions setting_;
    double wall_mm_;
    Vec3 gravity_mm_per_s2_;
    double size_mm_ = 0.0;
    double edge_mm_ = 0.0;  // mean, of the mesh
    double strength_pa_ = 0.0;
    double fracture_energy_j_m2_ = 0.0;
    std::optional<TearSpec> tear_;
    std::vector<Vec3> rest_mm_;            // per vertex
    std::vector<std::uint8_t> fixed_;      // per vertex
    std::vector<VertexPlace> tetrahedra_;  // of each, once asked for
    mutable WeakEdges weak_edges_;         // as they were shown last
    std::uint64_t followed_ = 1;           // version of the topology
    std::optional<Hold> hold_;
    std::unique_ptr<Stepper> stepper_;
};

}  // namespace hepatica
