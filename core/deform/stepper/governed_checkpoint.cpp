// SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints of a GovernedStepper: taken and restored as a whole.
#include <utility>

#include "core/base/error.h"
#include "core/deform/stepper/governed_stepper.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {
namespace {

[[noreturn]] void refuse_kind(bool of_checkpoint, const char* with, const char* without) {
    throw InputError(of_checkpoint ? with : without, "the checkpoint of a body",
                     "Make a stepper of that kind");
}

SurfacesKept overlaps_of(const StepperCheckpoint& checkpoint) {
    SurfacesKept kept;
    if (checkpoint.self) kept.self = checkpoint.self->overlaps;
    if (checkpoint.obstacles) kept.obstacles = checkpoint.obstacles->touch.overlaps;
    return kept;
}

}  // namespace

StepperCheckpoint GovernedStepper::checkpoint() const {
    StepperCheckpoint kept{.nodes = back_end_->state(),
                           .grabs = grabs_,
                           .gravity_mm_per_s2 = gravity_mm_per_s2_,
                           .unreported_tool_work = tool_work_,
                           .unreported_loss = lost_,
                           .still_s = still_s_,
                           .settled_s = settled_s_,
                           .last_kinetic = resting_.kinetic,
                           .last_elastic = resting_.elastic,
                           .last_grab = resting_.grab,
                           .last_tether = resting_.tether,
                           .solver = back_end_->checkpoint(),
                           .region = {},
                           .swing_mm_per_s = swing_.change_mm_per_s()};
    if (region_) kept.region = region_->checkpoint();
    const SurfacesKept overlaps = back_end_->overlaps();
    if (overlaps.self) kept.self = SelfCheckpoint{*overlaps.self, self_load_, resting_.contact};
    if (overlaps.obstacles)
        kept.obstacles =
            ObstacleCheckpoint{{*overlaps.obstacles, obstacle_load_.touch, resting_.contact},
                               obstacle_load_.force_un,
                               obstacle_load_.impulse_un_s};
    if (tearing_) kept.tear = tearing_->state();
    if (tool()) kept.tool = ToolCheckpoint{*tool(), tool_led_, tool_load_, resting_.contact};
    return kept;
}

void GovernedStepper::require_same_kind(const StepperCheckpoint& checkpoint) const {
    const std::size_t whole = nodes() - (tearing_ ? tearing_->report().vertices_split : 0);
    validate_checkpoint(checkpoint, whole + (checkpoint.tear ? checkpoint.tear->parents.size() : 0),
                        !back_end_->body().surface.empty());
    if (checkpoint.tear.has_value() != tearing_.has_value())
        refuse_kind(checkpoint.tear.has_value(), "is of a body that tears",
                    "is of a body that does not tear");
    if (checkpoint.region.has_value() != region_.has_value())
        refuse_kind(checkpoint.region.has_value(), "is of a stepper that computes a part",
                    "is of a stepper that computes the whole body");
    const SurfacesKept overlaps = back_end_->overlaps();
    if (checkpoint.self.has_value() != overlaps.self.has_value())
        refuse_kind(checkpoint.self.has_value(), "is of a body whose surfaces touch each other",
                    "is of a body whose surfaces do not touch each other");
    if (checkpoint.obstacles.has_value() != overlaps.obstacles.has_value())
        refuse_kind(checkpoint.obstacles.has_value(), "is of a body beside obstacles",
                    "is of a body without obstacles");
}

void GovernedStepper::restore(const StepperCheckpoint& checkpoint) {
    require_same_kind(checkpoint);
    std::optional<Tearing> tearing = tearing_;
    if (tearing) tearing->restore(*checkpoint.tear);
    std::optional<LiveRegion> region = region_;
    if (region && tearing) {
        region = new_region(region->options());
        region->follow_split(tearing->topology().parents());
    }
    if (region) region->restore(*checkpoint.region);
    restore_solver(checkpoint, std::move(tearing));
    // Nothing below throws, so the state is either restored completely or unchanged.
    region_ = std::move(region);
    restore_motion(checkpoint);
}

void GovernedStepper::restore_solver(const StepperCheckpoint& checkpoint,
                                     std::optional<Tearing> tearing) {
    const SurfacesKept overlaps = back_end_->overlaps();
    const BodyState present = back_end_->state();
    const std::optional<Tool> tool = back_end_->tool();
    const SolverCheckpoint solver = back_end_->checkpoint();
    tearing_.swap(tearing);
    try {
        if (tearing_) follow_tear(*back_end_);
        back_end_->set_overlaps(overlaps_of(checkpoint));
        back_end_->restore(checkpoint.solver);
    } catch (...) {
        tearing_.swap(tearing);
        if (tearing_) {
            follow_tear(*back_end_);
            back_end_->set_grabs(grabs_);
            back_end_->set_state(present);
            back_end_->set_tool(tool);
            if (region_) back_end_->freeze(frozen_nodes());
        }
        back_end_->set_overlaps(overlaps);
        if (tearing_) back_end_->restore(solver);
        throw;
    }
}

void GovernedStepper::restore_motion(const StepperCheckpoint& checkpoint) {
    stress_pa_.clear();
    back_end_->set_state(checkpoint.nodes);
    back_end_->set_overlaps(overlaps_of(checkpoint));
    self_load_ = checkpoint.self ? checkpoint.self->last_load : SelfLoad{};
    obstacle_load_ = {};
    if (const auto& kept = checkpoint.obstacles)
        obstacle_load_ = {kept->touch.last_load, kept->last_force_un, kept->last_impulse_un_s};
    const std::optional<ToolCheckpoint>& tool = checkpoint.tool;
    back_end_->set_tool(tool ? std::optional(tool->tool) : std::nullopt);
    tool_led_ = tool && tool->led;
    tool_load_ = tool ? tool->last_load : ToolLoad{};
    back_end_->set_grabs(checkpoint.grabs);
    back_end_->set_gravity(checkpoint.gravity_mm_per_s2);
    if (region_) back_end_->freeze(frozen_nodes());
    grabs_ = checkpoint.grabs;
    gravity_mm_per_s2_ = checkpoint.gravity_mm_per_s2;
    tool_work_ = checkpoint.unreported_tool_work;
    lost_ = checkpoint.unreported_loss;
    still_s_ = checkpoint.still_s;
    settled_s_ = checkpoint.settled_s;
    swing_.restore(checkpoint.swing_mm_per_s);
    resting_ = {};
    resting_.kinetic = checkpoint.last_kinetic;
    resting_.elastic = checkpoint.last_elastic;
    resting_.grab = checkpoint.last_grab;
    resting_.tether = checkpoint.last_tether;
    resting_.cohesion = back_end_->energies().cohesion;
    if (checkpoint.self) resting_.contact = checkpoint.self->last_contact;
    if (checkpoint.obstacles) resting_.contact = checkpoint.obstacles->touch.last_contact;
    if (tool) resting_.contact = tool->last_contact;
}

}  // namespace hepatica
