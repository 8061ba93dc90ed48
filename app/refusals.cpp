// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/refusals.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <variant>

#include "core/scene/deform_part.h"

namespace hepatica {

namespace {

// A sentence may hold numbers, so that a long way out of range has another in every step.
constexpr std::size_t most_sentences = 100;

template <class... Kinds>
bool is_one_of(const Command& command) {
    return (std::holds_alternative<Kinds>(command) || ...);
}

}  // namespace

void Refusals::add(std::uint64_t step, const std::string& message) {
    const auto known = std::ranges::find(all_, message, &Refusal::message);
    if (known != all_.end()) {
        ++known->times;
        return;
    }
    if (all_.size() == most_sentences) return;
    spdlog::warn("step {}: {}", step, message);
    all_.push_back({step, message, 1});
    if (all_.size() == most_sentences)
        spdlog::warn("further commands that are refused for other reasons are not told of");
}

nlohmann::ordered_json Refusals::json() const {
    auto list = nlohmann::ordered_json::array();
    for (const Refusal& refusal : all_)
        list.push_back(
            {{"step", refusal.step}, {"message", refusal.message}, {"times", refusal.times}});
    return list;
}

std::vector<std::string> moves_of_nothing(const World& world, std::span<const Command> commands) {
    std::vector<std::string> sentences;
    if (world.deform() == nullptr) return sentences;  // then the session refuses them by itself
    bool held = world.deform()->holding();
    bool tool = world.deform()->tool().has_value();
    for (const Command& command : commands) {
        if (is_one_of<GrabPoint, GrabVertex>(command)) held = true;
        if (is_one_of<AddTool>(command)) tool = true;
        if (is_one_of<ReleaseGrab, ResetWorld>(command)) held = false;
        if (is_one_of<RemoveTool, ResetWorld>(command)) tool = false;
        if (!held && is_one_of<MoveGrab, ShiftGrab>(command))
            sentences.emplace_back("nothing is in the hand that could be moved");
        if (!tool && is_one_of<MoveTool, ShiftTool>(command))
            sentences.emplace_back("there is no tool that could be moved");
    }
    return sentences;
}

}  // namespace hepatica
