// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::SessionInbox: one mutex over all that is handed over.
#include "core/session/session_inbox.h"

#include <utility>

namespace hepatica {

namespace {

// Whether the earlier command has no effect if the later one follows it.
bool supersedes(const Command& later, const Command& earlier) {
    const auto* from = std::get_if<MoveTool>(&earlier);
    const auto* to = std::get_if<MoveTool>(&later);
    if (from != nullptr && to != nullptr) return from->share == 1.0 && to->share == 1.0;
    return std::holds_alternative<MoveGrab>(later) && std::holds_alternative<MoveGrab>(earlier);
}

}  // namespace

std::uint64_t SessionInbox::post(Command command) {
    std::uint64_t number = 0;
    {
        const std::scoped_lock lock(mutex_);
        number = ++posted_;
        if (!commands_.empty() && supersedes(command, commands_.back()))
            commands_.back() = std::move(command);
        else
            commands_.push_back(std::move(command));
    }
    arrival_.notify_one();
    return number;
}

void SessionInbox::hand_over(QualityDial dial) {
    {
        const std::scoped_lock lock(mutex_);
        dial_ = std::move(dial);
    }
    arrival_.notify_one();
}

void SessionInbox::hand_over(BeginRecording begin) {
    {
        const std::scoped_lock lock(mutex_);
        recording_ = std::move(begin);
    }
    arrival_.notify_one();
}

bool SessionInbox::waited_for() const {
    const std::scoped_lock lock(mutex_);
    return waiting_ && empty();
}

void SessionInbox::post_first(Command command) {
    const std::scoped_lock lock(mutex_);
    commands_.insert(commands_.begin(), std::move(command));
}

std::vector<Command> SessionInbox::take_commands() {
    const std::scoped_lock lock(mutex_);
    taken_ = posted_;
    return std::exchange(commands_, {});
}

std::optional<QualityDial> SessionInbox::take_dial() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(dial_, std::nullopt);
}

std::optional<SessionInbox::BeginRecording> SessionInbox::take_recording() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(recording_, std::nullopt);
}

void SessionInbox::wait(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    waiting_ = true;
    arrival_.wait(lock, stop, [this] { return !empty(); });
    waiting_ = false;
}

// Unlike a sleeping thread, this wakes at a stop request.
void SessionInbox::sleep_until(std::chrono::steady_clock::time_point due,
                               const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    arrival_.wait_until(lock, stop, due, [] { return false; });
}

}  // namespace hepatica
