// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world that moves: a body and its settings, and what a person does to it by the
// hand (hand.h), by tools (tool_at_body.h) and by tearing it.
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
#include "core/scene/body_vertices.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/frame.h"
#include "core/scene/hand.h"
#include "core/scene/pressed_stretches.h"
#include "core/scene/scene_spec.h"
#include "core/scene/side_tears.h"
#include "core/scene/through_tears.h"
#include "core/scene/tools/tool_choice.h"
#include "core/scene/weak_edges.h"

namespace hepatica {

// The settings of the body that a person may change during play.
struct DeformSettings {
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
    double tether_pa_per_mm2 = 0.0;
    double wall_mm = 0.0;
    StepperOptions stepper;
    bool touchable = false;  // what tools need is built
    std::optional<TearSpec> tear{};
    std::optional<double> self_friction{};  // of vessels that touch each other; none: they do not
    bool obstacles = false;                 // vessels touch the obstacles
};

// Everything that determines the part's next steps, apart from the case and the scene's spec.
struct DeformCheckpoint {
    DeformSettings settings;
    std::optional<Hold> hold;
    StepperCheckpoint stepper;
};

// Not thread-safe. Positions are in mm, one per vertex of the present body.
class DeformPart {
  public:
    // Tissue makes a pull fade along the vessel, so that most of the tree may rest. Values chosen
    // with `bench region` (docs/solver.md): an error of at most a quarter of a millimetre for a
    // pull by two.
    static constexpr LiveRegionOptions region{.wake_radii = 3e-3, .still_radii_per_s = 1.5e-2};

    // Uses the spec's setting, or the setting at its quality on the patient's dial. Throws
    // InputError where the case has no mesh, the material is not known, or a value is out of range.
    // Other regions are for measurements: nothing freezes where still_radii_per_s is 0. `contact`
    // says whether tools are possible and whether vessels touch each other; vessels also touch
    // `obstacles`, and tear by `tear`.
    DeformPart(const PatientCase& patient, const DeformSpec& spec,
               const LiveRegionOptions& live_region = region,
               DeformBackEnd back_end = cpu_back_end(),
               const std::optional<ContactSpec>& contact = {},
               const std::optional<TearSpec>& tear = {},
               std::shared_ptr<const Obstacles> obstacles = {});
    ~DeformPart();

    // Closes the hand around the surface point nearest to point_mm: every vertex within about a
    // radius is pulled by a spring; all springs together are as stiff as the vessel.
    void grab(const Vec3& point_mm);
    void grab_vertex(int vertex);  // throws InputError if there is no such vertex
    void move_grab(const Vec3& target_mm);
    void release();
    // Brings a tool from outside along its direction until it is about to touch something or its
    // tip is at the point. Replaces the present tool. Throws InputError where the scene has no
    // tools, for values out of range, and where there is no room.
    void add_tool(const ToolChoice& choice, const Vec3& towards_mm);
    // Sets the target of the tool's centre for the next steps. Does nothing without a tool. Throws
    // InputError where it is not in patient space.
    void lead_tool(const Vec3& target_mm);
    // Adds a rotation about the tool's centre to the remaining one.
    void turn_tool(const Vec3& by_rad) { stepper_->turn_tool(by_rad); }
    // Moves the target opening of the jaws by this share of the way to 0 or to the widest opening.
    // Throws InputError for a tool without jaws; does nothing without a tool.
    void close_jaws(double share) { lead_jaws(false, share); }
    void open_jaws(double share) { lead_jaws(true, share); }
    void remove_tool() { stepper_->set_tool(std::nullopt); }
    const std::optional<Tool>& tool() const { return stepper_->tool(); }
    // Number of calls of add_tool() so far: tells a tool from one that replaced it.
    std::uint64_t tools_added() const { return tools_added_; }
    std::optional<ToolView> tool_view() const;

    // Sets how the body tears; none: it does not, and is made whole; a hand that holds a vertex of
    // a tear, which vanishes, opens. Throws InputError for values out of range, and where the
    // present setting's elements or solver cannot tear.
    void set_tear(const std::optional<TearSpec>& tear);
    bool tears() const { return tear_.has_value(); }
    TornSoFar torn_so_far() const;  // of a body that tears
    // The opening at which a parted joint has come apart; 0 where nothing can tear.
    double critical_opening_mm() const;
    // Where the tool presses on which vessel.
    std::vector<PressedStretch> pressed() const;
    // Where it is torn through.
    std::vector<ThroughTear> torn_through(const VesselTree& tree);
    // And where only the side of a vessel is open.
    TornPlaces torn_places(const VesselTree& tree);
    // |mass of the torn body - mass of the whole| / mass of the whole.
    double mass_error_relative() const;
    // Fills in counts, entropy and loads; also the rims if the view has origins.
    void show_tear(TearView& view) const;
    // Null where it does not tear.
    const TornTopology* torn() const;
    // Multiplies the strength by a factor of 0 to 1 along the way on the tree between the places
    // nearest to the two points, see joints_along. Throws InputError where the body does not tear,
    // the places are not connected, or a value is out of range.
    void cut_line(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm, double strength);
    // Moves a blade through the vessel nearest to its way, see blade_sweep. Throws InputError where
    // the body does not tear or the way is not in patient space.
    void cut(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm);
    // Makes the body whole and removes cut lines.
    void mend();

    bool holding() const { return hold_.has_value(); }
    const Vec3& hand_mm() const { return hold_->target_mm; }  // only while holding
    std::optional<GrabView> grab_view() const;

    // Settings that keep the state. They throw InputError for values out of range. Where they
    // throw, setting and state are unchanged.
    void set_gravity(const Vec3& gravity_mm_per_s2);
    void set_tether(double pa_per_mm2);
    void set_wall(double wall_mm);  // see DeformSpec
    // Builds what tools need, or removes it together with the present tool.
    void set_touchable(bool touchable);
    bool touchable() const { return body_.touchable; }
    // Sets what the vessels touch: each other, with Coulomb's coefficient, and these obstacles;
    // none: nothing. A change puts the body at rest and makes it whole, without hand and tool.
    // Throws InputError for a coefficient out of range.
    void set_contact(const std::optional<double>& self_friction,
                     std::shared_ptr<const Obstacles> obstacles);
    void use(const StepperOptions& setting);
    const StepperOptions& setting() const { return setting_; }
    // The device that makes the steps now; empty: the processor.
    std::string device() const { return stepper_->on_device() ? back_end_.device : ""; }
    DeformSettings settings() const;
    // Settings that are already in force cost nothing and do not change the bits of later steps.
    // `obstacles` are used where the settings want some; null: the present ones.
    void use(const DeformSettings& settings, std::shared_ptr<const Obstacles> obstacles = {});

    // As Stepper::step: after Cancelled, restore() must be called before another step.
    StepReport step(double dt_s, const std::stop_token& stop = {},
                    const Stepper::PartDone& part_done = {});
    std::span<const Vec3> positions_mm() const { return stepper_->positions_mm(); }
    std::span<const Vec3> velocities_mm_per_s() const { return stepper_->velocities_mm_per_s(); }
    // Rest positions; vertices that were split off have those of their parents.
    const std::vector<Vec3>& rest_positions_mm() const { return vertices_->rest_mm(); }
    const BodyDescription& body() const { return body_; }  // as built from the case: whole
    TetMesh shape() const;                                 // as it is now, torn
    // The state for snapshots: every node of the present element, the vertices first. set_state()
    // takes the state of another element by its vertices.
    BodyState state() const { return stepper_->state(); }
    void set_state(const BodyState& state) { give_state(*stepper_, state); }

    // Costs a copy of a few arrays.
    DeformCheckpoint checkpoint() const;
    // Continues with the same bits as the part that the checkpoint was taken from, given the same
    // case and spec. Costs a factorisation. `obstacles` as in use(). Throws InputError where the
    // checkpoint is not of this body.
    void restore(const DeformCheckpoint& checkpoint,
                 std::shared_ptr<const Obstacles> obstacles = {});
    // Hash of everything in a checkpoint: equal hashes mean equal next steps.
    std::uint64_t state_hash() const;

    const std::vector<VertexPlace>& places() const { return vertices_->places(); }

    // False where a position is not finite or farther from its rest position than ten times the
    // body's size.
    bool plausible() const;

  private:
    void lead_jaws(bool open, double share);
    std::optional<TearLaw> law_of(const std::optional<TearSpec>& tear) const;
    std::shared_ptr<const std::vector<float>> vertex_loads() const;
    const std::vector<VertexPlace>& places_of_tetrahedra(const VesselTree& tree);
    void require_tear() const;
    int vertex_near(const Vec3& point_mm) const;  // throws InputError beyond patient space
    // Lets what is kept per vertex follow the body's vertices.
    void follow_tear() { vertices_->follow(body_.mesh, torn()); }
    void give_state(Stepper& stepper, const BodyState& state) const;
    // Closes the hand around a vertex; the held point is `point_mm`.
    void close_hand(int vertex, const Vec3& point_mm);
    // The largest pressure of a hand or a tool over the section that it holds. Where vessels may
    // tear, it is high enough to tear them.
    double hand_pressure_pa() const;
    // The hand is unchanged where the stepper throws.
    void set_hold(std::optional<Hold> hold);
    // Continues from the present state with another body or setting.
    void rebuild(BodyDescription body, const StepperOptions& setting);

    LiveRegionOptions region_;
    DeformBackEnd back_end_;
    BodyDescription body_;
    std::uint64_t obstacles_hash_ = 0;
    std::optional<BodyVertices> vertices_;  // always set, once the mesh is known to be there
    StepperOptions setting_;
    double wall_mm_;
    Vec3 gravity_mm_per_s2_;
    double size_mm_ = 0.0;
    double edge_mm_ = 0.0;  // mean, of the mesh
    double strength_pa_ = 0.0;
    double fracture_energy_j_m2_ = 0.0;
    std::optional<TearSpec> tear_;
    std::vector<VertexPlace> tetrahedra_;  // places of the tetrahedra, once needed
    mutable WeakEdges weak_edges_;         // as they were shown last
    std::optional<Hold> hold_;
    std::uint64_t tools_added_ = 0;
    std::unique_ptr<Stepper> stepper_;
};

}  // namespace hepatica
