// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::Session::apply: what each command does to the world and to the session.
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/flow/fluid.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/world.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

double checked_share(double share) {
    if (share >= 0.0 && share <= 1.0) return share;
    throw InputError("is " + number_text(share), "the share of the tool's way",
                     "Choose a value from 0 to 1");
}

double checked_time_of_move(double over_s) {
    if (over_s > 0.0 && over_s <= longest_move_s) return over_s;
    throw InputError("is " + number_text(over_s) + " s", "the time of a move",
                     "Choose a value above 0, up to 1");
}

// An injection takes 0 for none.
double checked_viscosity(double pa_s) {
    Fluid drug = pure(blood());
    drug.viscosity_pa_s = pa_s;
    validate(drug);
    return pa_s;
}

}  // namespace

struct Session::Apply {
    Session& session;
    World& world;
    const std::stop_token& stop;

    // The parts, for commands that need them.
    DeformPart& deform() const {
        if (world.deform() == nullptr)
            throw InputError("nothing moves in this scene", world.spec().name,
                             "Add \"deform\" to the scene");
        return *world.deform();
    }
    FlowPart& flow() const {
        if (world.flow() == nullptr)
            throw InputError("nothing flows in this scene", world.spec().name,
                             "Add \"flow\" to the scene");
        return *world.flow();
    }

    // The hand. What is refused does not end the way that it is on.
    void operator()(const GrabPoint& c) const {
        deform().grab(c.point_mm);
        session.hand_.stay();
    }
    void operator()(const GrabVertex& c) const {
        deform().grab_vertex(c.vertex);
        session.hand_.stay();
    }
    void operator()(const MoveGrab& c) const;
    void operator()(const ShiftGrab& c) const;
    void operator()(const ReleaseGrab&) const { deform().release(); }

    // The tool.
    void operator()(const AddTool& c) const {
        deform().add_tool({c.kind, c.radius_mm, c.length_mm, c.direction, c.side}, c.point_mm);
        session.led_tool_.stay();
    }
    void operator()(const MoveTool& c) const;
    void operator()(const ShiftTool& c) const;
    void operator()(const RemoveTool&) const { deform().remove_tool(); }
    void operator()(const TurnTool& c) const { deform().turn_tool(c.by_rad); }
    void operator()(const CloseForceps& c) const { deform().close_jaws(checked_share(c.share)); }
    void operator()(const OpenForceps& c) const { deform().open_jaws(checked_share(c.share)); }
    void operator()(const UseTools& c) const {
        deform().set_touchable(c.on);
        session.dial_.forget_costs();
    }
    void operator()(const UseContact& c) const;

    // Tearing.
    void operator()(const CutLine& c) const {
        deform().cut_line(world.patient().tree, c.from_mm, c.to_mm, c.strength);
    }
    void operator()(const Blade& c) const {
        deform().cut(world.patient().tree, c.from_mm, c.to_mm);
    }
    void operator()(const UseTear& c) const;

    // The drug.
    void operator()(const InjectDrug& c) const {
        Injection injection{world.place_near(c.point_mm), c.mass_flow_g_s, c.void_fraction,
                            c.second_phase, c.pressure_model};
        if (c.drug_viscosity_pa_s)
            injection.drug_viscosity_pa_s = checked_viscosity(*c.drug_viscosity_pa_s);
        injection.tears = world.torn_now();
        flow().inject(injection);
    }
    void operator()(const FinishInjection&) const;
    void operator()(const RemoveDrug&) const { flow().remove_drug(); }
    void operator()(const PlayDrug& c) const { flow().play(c.playing); }
    void operator()(const SetDrugTime& c) const { flow().set_time(c.time_s); }
    void operator()(const SetDrugSpeed& c) const { flow().set_speed(c.factor); }

    // The body and what acts on it.
    void operator()(const SetGravity& c) const { deform().set_gravity(c.gravity_mm_per_s2); }
    void operator()(const SetTether& c) const { deform().set_tether(c.pa_per_mm2); }
    void operator()(const SetWall& c) const {
        deform().set_wall(c.wall_mm);
        session.dial_.forget_costs();
    }

    // The dial.
    void operator()(const SetQuality& c) const;
    void operator()(const SetAutomaticQuality& c) const;
    void operator()(const UseSetting& c) const;

    // The play.
    void operator()(const SetPaused& c) const;
    void operator()(const ResetWorld&) const;
    void operator()(const RestoreSnapshot&) const;
};

void Session::Apply::operator()(const MoveGrab& c) const {
    if (!c.over_s) {
        deform().move_grab(c.target_mm);
        return session.hand_.stay();
    }
    const double over_s = checked_time_of_move(*c.over_s);
    if (deform().holding()) session.hand_.lead_to(c.target_mm, over_s);
}

void Session::Apply::operator()(const ShiftGrab& c) const {
    if (deform().holding()) deform().move_grab(deform().hand_mm() + c.by_mm);
    session.hand_.stay();
}

void Session::Apply::operator()(const MoveTool& c) const {
    checked_share(c.share);
    if (!deform().tool()) return;
    if (c.over_s) return session.led_tool_.lead_to(c.target_mm, checked_time_of_move(*c.over_s));
    const Vec3 led = deform().tool()->target_mm;
    deform().lead_tool(c.share == 1.0 ? c.target_mm : Vec3(led + c.share * (c.target_mm - led)));
    session.led_tool_.stay();
}

void Session::Apply::operator()(const ShiftTool& c) const {
    if (deform().tool()) deform().lead_tool(deform().tool()->target_mm + c.by_mm);
    session.led_tool_.stay();
}

// Whether an injection can flow is known only after it was computed. By then the world has changed,
// because it no longer waits for the computation; so the command counts as applied, not as refused.
void Session::Apply::operator()(const FinishInjection&) const {
    try {
        flow().finish_injection(stop);
    } catch (const InputError& error) {
        session.say_refused(error.what());
    }
}

// The former last good state is of another scene and cannot be restored.
void Session::Apply::operator()(const UseContact& c) const {
    deform();
    if (!world.use_contact(c.self, c.obstacles, c.friction))
        session.message_ = "This case knows neither liver nor tumours: nothing stands in the way";
    session.dial_.forget_costs();
    session.last_good_ = std::make_shared<const Keyframe>(session.keyframe());
}

// While vessels tear, the dial has only the settings that can. Everything that may be refused is
// checked before the setting changes.
void Session::Apply::operator()(const UseTear& c) const {
    DeformPart& part = deform();
    if (!c.on) {
        part.set_tear(std::nullopt);
        return session.take_dial(session.whole_dial_);
    }
    validate_tear_factor(c.tear_factor);
    const QualityDial able = dial_that_tears(session.whole_dial_);
    if (part.setting().order != ElementOrder::linear ||
        part.setting().solver == LinearSolverKind::skeleton) {
        part.use(able.at(session.dial_.quality().value_or(0.5)).options);
        // Recorded before this command: the dial where it is replayed may be another.
        session.recorded_.commands.emplace_back(UseSetting{part.setting()});
    }
    TearSpec tear = part.settings().tear.value_or(TearSpec{});
    tear.tear_factor = c.tear_factor;
    part.set_tear(tear);
    session.take_dial(session.whole_dial_);
}

void Session::Apply::operator()(const SetQuality& c) const {
    if (!(c.quality >= 0.0 && c.quality <= 1.0))
        throw InputError("is " + number_text(c.quality), "quality", "Choose a value from 0 to 1");
    session.dial_.turn(c.quality, deform());
}

void Session::Apply::operator()(const SetAutomaticQuality& c) const {
    DeformPart& part = deform();
    session.dial_.set_automatic(false);
    if (c.automatic) session.dial_.turn_automatically(session.budget_ms(), part);
}

void Session::Apply::operator()(const UseSetting& c) const {
    deform().use(c.setting);
    session.dial_.follow(deform());
    session.dial_.set_automatic(false);
}

void Session::Apply::operator()(const SetPaused& c) const {
    session.paused_ = c.paused;
    if (!c.paused) session.forget_divergence();
}

void Session::Apply::operator()(const ResetWorld&) const {
    world.reset();
    session.last_good_ = std::make_shared<const Keyframe>(session.keyframe());
    session.paused_ = false;
    session.forget_divergence();
}

void Session::Apply::operator()(const RestoreSnapshot&) const {
    const bool holding = world.deform() != nullptr && world.deform()->holding();
    session.take_back(!holding, world.deform() != nullptr && !world.deform()->tool());
    session.paused_ = false;
    session.forget_divergence();
}

void Session::apply(const Command& command, const std::stop_token& stop) {
    std::visit(Apply{*this, *world_, stop}, command);
    world_->follow_tear();
}

}  // namespace hepatica
