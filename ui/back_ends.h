// SPDX-License-Identifier: GPL-3.0-or-later
// Which back end makes the steps of what is played in the window: what the user chose, and what
// there is of that. The program brings the ways to make back ends; the window knows no device.
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

#include "core/scene/deform_back_end.h"

namespace hepatica {

// Any thread.
class BackEnds {
  public:
    using Say = std::function<void(const std::string& words)>;
    // One of its own for whoever plays, by a name that the command line takes. What a person should
    // know, such as that a device failed, it says then and later, on the thread that makes steps.
    // Throws InputError where there is none of that name.
    using Make = std::function<DeformBackEnd(const std::string& name, const Say& say)>;

    // The processor's alone.
    BackEnds();
    explicit BackEnds(Make make) : make_(std::move(make)) {}

    void choose(const std::string& name);
    std::string chosen() const;

    // Of the choice. Where that is not to be had, this is said, and the processor plays.
    DeformBackEnd for_play();
    // That a recording was made with. Throws InputError where it is not to be had.
    DeformBackEnd named(const std::string& name);

    // What there is to say goes here, the same words once for each choice. An earlier one is not
    // called any more after this returns; an empty function removes it.
    void on_words(Say say);

  private:
    void say(const std::string& words);

    Make make_;
    mutable std::mutex mutex_;  // guards what follows
    std::string chosen_ = "cpu";
    std::set<std::string> said_;
    Say say_;
};

}  // namespace hepatica
