// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/back_ends.h"

#include <utility>

#include "core/base/error.h"

namespace hepatica {

BackEnds::BackEnds()
    : make_([](const std::string& name, const Say&) {
          if (name == "cpu") return cpu_back_end();
          throw InputError("is not to be had here", name, "Let the processor make the steps");
      }) {}

void BackEnds::choose(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    chosen_ = name;
    said_.clear();
}

std::string BackEnds::chosen() const {
    const std::scoped_lock lock(mutex_);
    return chosen_;
}

DeformBackEnd BackEnds::for_play() {
    try {
        return named(chosen());
    } catch (const InputError& error) {
        say("The chosen back end is not to be had, so that the processor makes the steps: " +
            error.problem() + ". " + error.remedy());
        return cpu_back_end();
    }
}

DeformBackEnd BackEnds::named(const std::string& name) {
    return make_(name, [this](const std::string& words) { say(words); });
}

void BackEnds::on_words(Say say) {
    const std::scoped_lock lock(mutex_);
    say_ = std::move(say);
}

void BackEnds::say(const std::string& words) {
    const std::scoped_lock lock(mutex_);
    if (say_ && said_.insert(words).second) say_(words);
}

}  // namespace hepatica
