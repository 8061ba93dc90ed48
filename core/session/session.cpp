// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <new>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/scene/bleeding.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/setting_json.h"
#include "core/scene/world.h"

namespace hepatica {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t steps_between_snapshots = 60;   // a second of play
constexpr std::uint64_t steps_between_keyframes = 600;  // every tenth snapshot is one
constexpr std::size_t longest_message = 512;
constexpr double most_for_drawing = 0.6;  // of a frame: limit on the time for drawing

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A move over some time, of which each piece is recorded.
bool begins_way(const Command& command) {
    const auto* grab = std::get_if<MoveGrab>(&command);
    const auto* tool = std::get_if<MoveTool>(&command);
    return (grab != nullptr && grab->over_s) || (tool != nullptr && tool->over_s);
}

}  // namespace

Session::Session(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job,
                 const DeformBackEnd& back_end)
    : whole_dial_(dial_of(*patient, back_end)),
      dial_(spec.tear ? dial_that_tears(whole_dial_) : whole_dial_),
      world_(std::make_unique<World>(patient, spec, job, back_end)),
      felt_force_(spec.dt_s) {
    message_.reserve(longest_message);
    recording_start_.program = program_version();
    recording_start_.back_end = back_end.name;
    recording_start_.patient_hash = hash_of(*patient);
    recording_start_.scene = spec;
    if (const DeformPart* deform = world_->deform(); deform != nullptr) {
        recording_start_.scene.deform->setting = deform->setting();
        dial_.follow(*deform);
    }
    last_good_ = std::make_shared<const Keyframe>(keyframe());
    SessionStep first;
    publish(first, Clock::now());
}

Session::~Session() = default;

void Session::on_frame(std::function<void()> tell) {
    const std::scoped_lock lock(listener_mutex_);
    tell_of_frame_ = std::move(tell);
}

// The last good state is set to the start of the recording, so that a replay can restore it, too.
void Session::begin_waiting_recording() {
    const std::optional<SessionInbox::BeginRecording> begin = inbox_.take_recording();
    if (!begin) return;
    keep_ = nullptr;
    if (!*begin) return;
    recorded_from_ = step_ - 1;
    recorded_ = {};
    last_good_ = std::make_shared<const Keyframe>(keyframe());
    Recording start = recording_start_;
    auto first = std::make_shared<Keyframe>(*last_good_);
    first->step = 0;
    start.begin = std::move(first);
    keep_ = (*begin)(start);
    if (paused_) recorded_.commands.emplace_back(SetPaused{true});  // a keyframe is not paused
}

void Session::apply_waiting_commands(const std::stop_token& stop) {
    const std::vector<Command> commands = inbox_.take_commands();
    std::optional<QualityDial> dial = inbox_.take_dial();
    if (!commands.empty() && !diverged_) message_.clear();
    if (dial) take_dial(std::move(*dial));
    if (std::exchange(setting_changed_, false))
        recorded_.commands.emplace_back(UseSetting{world_->deform()->setting()});
    for (const Command& command : commands) apply_and_record(command, stop);
    lead_on(stop);
}

bool Session::apply_and_record(const Command& command, const std::stop_token& stop) {
    try {
        apply(command, stop);
    } catch (const InputError& error) {
        say_refused(error.what());
        return false;
    }
    if (!begins_way(command)) recorded_.commands.push_back(as_recorded(command));
    return true;
}

void Session::say_refused(const char* why) {
    message_ = why;
    refused_.emplace_back(why);
}

// Each piece of a timed move is applied as an immediate move, which would end the timed one.
void Session::lead_on(const std::stop_token& stop) {
    const DeformPart* deform = world_->deform();
    const double dt_s = paused_ ? longest_move_s : world_->spec().dt_s;
    if (LedPoint hand = std::exchange(hand_, {}); hand.underway() && deform->holding()) {
        const MoveGrab piece{hand.next(deform->hand_mm(), dt_s)};
        if (apply_and_record(piece, stop)) hand_ = hand;
    }
    if (LedPoint tool = std::exchange(led_tool_, {}); tool.underway() && deform->tool()) {
        const MoveTool piece{tool.next(deform->tool()->target_mm, dt_s)};
        if (apply_and_record(piece, stop)) led_tool_ = tool;
    }
}

Command Session::as_recorded(const Command& command) const {
    const bool dial = std::holds_alternative<SetQuality>(command) ||
                      std::holds_alternative<SetAutomaticQuality>(command);
    return dial ? Command(UseSetting{world_->deform()->setting()}) : command;
}

void Session::take_dial(QualityDial dial) {
    DeformPart* deform = world_->deform();
    const bool tears = deform != nullptr && deform->tears();
    const DialInUse before = dial_;
    try {
        if (dial_.take(tears ? dial_that_tears(dial) : dial, deform, budget_ms()))
            setting_changed_ = true;
        whole_dial_ = std::move(dial);
    } catch (const InputError& error) {
        dial_ = before;
        say_refused(error.what());
    }
}

double Session::budget_ms() const {
    const double period_ms = 1e3 * world_->spec().dt_s;
    return period_ms - std::clamp(drawing_ms_.load(), 0.0, most_for_drawing * period_ms);
}

void Session::forget_divergence() {
    if (diverged_) message_.clear();
    diverged_ = false;
}

Keyframe Session::keyframe() const {
    return {step_, played_steps_, dial_.automatic(), world_->checkpoint()};
}

void Session::restore(const Keyframe& keyframe) {
    const bool tears = keyframe.world.deform && keyframe.world.deform->settings.tear;
    DialInUse dial(tears ? dial_that_tears(whole_dial_) : whole_dial_);
    world_->restore(keyframe.world);
    dial_ = std::move(dial);
    step_ = keyframe.step;
    played_steps_ = keyframe.played_steps;
    dial_.set_automatic(keyframe.automatic);
    setting_changed_ = paused_ = diverged_ = failed_ = false;
    measured_ms_.reset();
    hand_.stay();
    led_tool_.stay();
    message_.clear();
    if (world_->deform() != nullptr) dial_.follow(*world_->deform());
    last_good_ = std::make_shared<const Keyframe>(keyframe);
}

void Session::guard_state() {
    ++played_steps_;
    if (world_->deform() != nullptr && !world_->deform()->plausible()) {
        take_back(true, true);
        paused_ = true;
        diverged_ = true;
        message_ =
            "The simulation diverged: it was taken back to its last good state and stopped. "
            "Resume to go on";
    } else if (played_steps_ % steps_between_snapshots == 0) {
        last_good_ = std::make_shared<const Keyframe>(keyframe());
        if (played_steps_ % steps_between_keyframes == 0) recorded_.keyframe = last_good_;
    }
}

void Session::take_back(bool open_hand, bool without_tool) {
    hand_.stay();
    led_tool_.stay();
    DeformPart* deform = world_->deform();
    FlowPart* flow = world_->flow();
    std::optional<DeformSettings> chosen;
    if (deform != nullptr) chosen = deform->settings();
    const double drug_speed = flow != nullptr ? flow->speed() : 1.0;
    world_->restore(last_good_->world);
    if (flow != nullptr) flow->set_speed(drug_speed);
    if (deform == nullptr) return;
    if (open_hand) deform->release();
    if (without_tool) deform->remove_tool();
    deform->use(*chosen);
    world_->follow_tear();  // the chosen settings may have made it whole
}

template <class Work>
void Session::shielded(const Work& work) noexcept {
    try {
        work();
    } catch (const Cancelled&) {
        stop_after("it was told to within a step", "What was done in the last second is lost");
    } catch (const std::bad_alloc&) {
        stop_after("there was not enough memory", "Close other programs or make the scene smaller");
    } catch (const std::exception& error) {
        stop_after(error.what(), "Save what you need: it may happen again");
    } catch (...) {
        stop_after("an error without a name", "Save what you need: it may happen again");
    }
}

// Allocates nothing: the text is cut to the memory that message_ already has.
void Session::stop_after(const char* what, const char* remedy) noexcept {
    failed_ = true;
    paused_ = true;
    diverged_ = true;
    message_ = "The simulation stopped: ";
    message_.append(what, std::min(std::strlen(what), longest_message / 2));
    message_ += ". It goes back to its last good state; resume to go on. ";
    message_ += remedy;
}

void Session::recover() {
    take_back(true, true);
    failed_ = false;
    recorded_.keyframe.reset();
    const DeformPart* deform = world_->deform();
    if (deform != nullptr) recorded_.commands.emplace_back(ReleaseGrab{});
    if (deform != nullptr && deform->touchable()) recorded_.commands.emplace_back(RemoveTool{});
    recorded_.commands.emplace_back(RestoreSnapshot{});
    recorded_.commands.emplace_back(SetPaused{true});
}

void Session::show_to_watch(const Frame& frame, const std::stop_token& stop) {
    if (!watch_) return;
    try {
        if (!watch_(watched_, frame, stop)) watch_ = nullptr;
    } catch (...) {
        watch_ = nullptr;
        throw;
    }
}

void Session::keep_step(SessionStep& step) {
    if (watch_) watched_ = recorded_.commands;
    if (!keep_) return;
    try {
        step.state_hash = recorded_.state_hash = state_hash();
        if (recorded_.keyframe && recorded_from_ > 0) {
            auto numbered = std::make_shared<Keyframe>(*recorded_.keyframe);
            numbered->step -= recorded_from_;
            recorded_.keyframe = std::move(numbered);
        }
        keep_(std::move(recorded_));
    } catch (...) {
        keep_ = nullptr;  // a recording must have no gap, so it ends here
        throw;
    }
}

// Before a step and not behind the one that was measured: between the two the state is as it was
// recorded, also where no further step comes.
void Session::govern() {
    const std::optional<double> step_ms = std::exchange(measured_ms_, std::nullopt);
    if (step_ms && dial_.govern(*step_ms, budget_ms(), world_->deform())) setting_changed_ = true;
}

SessionStep Session::step(const std::stop_token& stop) {
    const Clock::time_point start = Clock::now();
    Clock::time_point shown = start;
    SessionStep done;
    const auto wait_ends = [&] {
        done.longest_wait_ms = std::max(done.longest_wait_ms, milliseconds_since(shown));
        shown = Clock::now();
    };
    const auto part_done = [&](double share) {
        if (milliseconds_since(shown) < show_parts_after_ms_) return;
        publish_part(share);
        wait_ends();
    };
    done.step = ++step_;
    if (!std::exchange(stopped_, false)) recorded_ = {};
    shielded([&] {
        if (failed_) recover();
        govern();
        begin_waiting_recording();
        apply_waiting_commands(stop);
        done.paused = paused_;
        if (paused_) return;
        done.deform = world_->step(stop, part_done);
        guard_state();
    });
    done.refused = std::exchange(refused_, {});
    if (failed_ && stop.stop_requested()) {
        stopped_ = true;
        --step_;
        done.stopped = true;
        return done;
    }
    if (failed_) shielded([&] { recover(); });
    shielded([&] { keep_step(done); });
    shielded([&] {
        resting_ = rests_after(done);
        publish(done, start, stop);
        wait_ends();
        if (!done.paused && !done.deform.asleep) measured_ms_ = done.step_ms;
    });
    return done;
}

SessionStep Session::step(const Job& job) {
    SessionStep done = step(job.stop_token());
    if (done.stopped) job.throw_if_cancelled();
    return done;
}

bool Session::rests_after(const SessionStep& done) const {
    const FlowPart* flow = world_->flow();
    if (failed_ || (flow != nullptr && flow->waits_for_finish())) return false;
    if (done.paused) return true;
    if (flow != nullptr && flow->computing()) return false;  // shown some steps later
    if (watch_ || hand_.underway() || led_tool_.underway()) return false;
    const Bleeding* bleeding = world_->bleeding();
    if (bleeding != nullptr && bleeding->leak_g_s() > 0.0) return false;
    const bool still = world_->deform() == nullptr || done.deform.asleep;
    return still && !(flow != nullptr && flow->drug().playing);
}

void Session::finish_injection() {
    if (world_->flow() != nullptr && world_->flow()->update_waits())
        inbox_.post_first(FinishInjection{});
}

void Session::finish_ready_injection() {
    if (world_->flow() == nullptr || !world_->flow()->injection_ready()) return;
    inbox_.post_first(FinishInjection{});  // queued commands may start another injection
}

void Session::run(const std::stop_token& stop) {
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(world_->spec().dt_s));
    Clock::time_point due = Clock::now();
    Clock::time_point last = due - period;
    while (!stop.stop_requested()) {
        const Clock::time_point now = Clock::now();
        const double factor = std::chrono::duration<double>(period) / (now - last);
        constexpr double smoothing = 0.05;  // average over about twenty steps
        real_time_factor_ += smoothing * (factor - real_time_factor_);
        last = now;
        shielded([&] { finish_ready_injection(); });
        step(stop);
        if (resting_) {
            inbox_.wait(stop);
            due = Clock::now();
            last = due - period;  // waiting for a command is no delay
            continue;
        }
        due = std::max(due + period, Clock::now());  // lost time is not caught up
        inbox_.sleep_until(due, stop);
    }
}

std::uint64_t Session::state_hash() const {
    const std::array<std::uint64_t, 2> state{world_->state_hash(), paused_ ? 1U : 0U};
    Hasher hasher;
    hasher.add(std::span<const std::uint64_t>(state));
    return hasher.value();
}

void Session::publish(SessionStep& step, Clock::time_point start, const std::stop_token& stop) {
    Frame& frame = frames_.back();
    world_->fill(frame);
    frame.step = step_;
    FrameStatistics& statistics = frame.statistics;
    statistics.real_time_factor = std::min(1.0, real_time_factor_);
    statistics.linear_iterations = step.deform.linear_iterations;
    if (const DeformPart* deform = world_->deform(); deform != nullptr) {
        statistics.setting = words_of(deform->setting());
        statistics.device = deform->device();
        dial_.fill(statistics);
    }
    statistics.degraded = step.deform.degraded;
    statistics.paused = paused_;
    statistics.diverged = diverged_;
    statistics.resting = resting_;
    statistics.message_of_solver = message_.empty() && !step.deform.message.empty();
    statistics.message = message_.empty() ? step.deform.message : message_;
    felt_force_.see(frame);
    felt_force_.show_in(frame);
    show_to_watch(frame, stop);
    // Measured last, so that filling the frame counts; publishing is one exchange of an index.
    statistics.step_ms = step.step_ms = milliseconds_since(start);
    shown_ = statistics;
    hand_over_frame();
}

void Session::publish_part(double share) {
    if (!world_->deform()->plausible()) return;  // the step will be taken back
    Frame& frame = frames_.back();
    world_->fill(frame);
    frame.step = step_;
    frame.time_s += share * world_->spec().dt_s;
    frame.statistics = shown_;
    frame.statistics.paused = frame.statistics.resting = frame.statistics.diverged = false;
    frame.statistics.message = message_;
    frame.statistics.message_of_solver = false;
    felt_force_.show_in(frame);
    within_step_ = true;
    hand_over_frame();
    within_step_ = false;
}

void Session::hand_over_frame() {
    frames_.publish();
    const std::scoped_lock lock(listener_mutex_);
    if (tell_of_frame_) tell_of_frame_();
}

}  // namespace hepatica
