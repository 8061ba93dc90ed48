// SPDX-License-Identifier: GPL-3.0-or-later
// What a session refused while a script was played: told as it happens, each sentence once, and
// kept for the answer, up to a hundred of them. Without it a play would measure another script than
// the one that was given.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/scene/world.h"
#include "core/session/command.h"

namespace hepatica {

class Refusals {
  public:
    // Warns where it is the first of this sentence.
    void add(std::uint64_t step, const std::string& message);

    // A list of {"step", "message", "times"}, in order of their first steps.
    nlohmann::ordered_json json() const;

  private:
    struct Refusal {
        std::uint64_t step = 0;  // the first
        std::string message;
        std::uint64_t times = 0;
    };
    std::vector<Refusal> all_;
};

// Sentences for commands of the next step that would move what is not there. The session bears them
// in silence, because a hand in the window may be emptied amid its way.
std::vector<std::string> moves_of_nothing(const World& world, std::span<const Command> commands);

}  // namespace hepatica
