// SPDX-License-Identifier: GPL-3.0-or-later
// The back end that computes the steps of a play: the user's choice, or the processor if that is
// unavailable. The program provides the factory; the window knows no device.
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

#include "core/scene/deform_back_end.h"

namespace hepatica {

// Thread-safe.
class BackEnds {
  public:
    using Say = std::function<void(const std::string& words)>;
    // Makes a back end by its command line name, a separate one for each play. It reports messages
    // for the user, such as the failure of a device, through `say`, also later on the thread that
    // makes steps. Throws InputError for an unknown or unavailable name.
    using Make = std::function<DeformBackEnd(const std::string& name, const Say& say)>;

    // With the processor alone.
    BackEnds();
    explicit BackEnds(Make make) : make_(std::move(make)) {}

    void choose(const std::string& name);
    std::string chosen() const;

    // The chosen back end; if it is unavailable, says so and returns the processor's.
    DeformBackEnd for_play();
    // The back end that a recording names. Throws InputError if it is unavailable.
    DeformBackEnd named(const std::string& name);

    // Sets the receiver of messages; each text is sent once per choice. After this returns, the
    // former receiver is no longer called; an empty function removes it.
    void on_words(Say say);

  private:
    void say(const std::string& words);

    Make make_;
    mutable std::mutex mutex_;  // guards the members below
    std::string chosen_ = "cpu";
    std::set<std::string> said_;
    Say say_;
};

}  // namespace hepatica
