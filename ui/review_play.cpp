// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review_play.h"

#include <utility>
#include <variant>

namespace hepatica {

namespace {

// Movements of a hand or tool that does not exist in a review.
bool is_movement(const Command& command) {
    return std::holds_alternative<MoveGrab>(command) ||
           std::holds_alternative<ShiftGrab>(command) ||
           std::holds_alternative<ReleaseGrab>(command) ||
           std::holds_alternative<MoveTool>(command) ||
           std::holds_alternative<ShiftTool>(command) ||
           std::holds_alternative<RemoveTool>(command);
}

bool stops_or_starts(const Command& command) {
    return std::holds_alternative<SetPaused>(command) || std::holds_alternative<PlayDrug>(command);
}

}  // namespace

void ReviewScreen::show_at(double at_s) {
    const std::shared_ptr<const Frame> frame = tape->at(at_s);
    if (frame == nullptr || frame == wanted) return;
    wanted = frame;
    if (tell) tell();
}

ReviewPlay::ReviewPlay(std::shared_ptr<ReviewScreen> screen)
    : screen_(std::move(screen)), shown_(screen_->wanted) {}

ReviewPlay::~ReviewPlay() {
    screen_->tell = nullptr;
    if (const auto gone = std::exchange(screen_->gone, nullptr)) gone();
}

void ReviewPlay::post(Command command) {
    if (stops_or_starts(command)) {
        if (screen_->hold) screen_->hold();
    } else if (!is_movement(command) && screen_->touched) {
        screen_->touched();
    }
}

bool ReviewPlay::update_frame() {
    return std::exchange(shown_, screen_->wanted) != screen_->wanted;
}

}  // namespace hepatica
