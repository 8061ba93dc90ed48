// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that are called after every change of something.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace hepatica {

// Not thread-safe. A watcher must not add another one.
class Watchers {
  public:
    void add(std::function<void()> watcher) { watchers_.push_back(std::move(watcher)); }
    void tell() const {
        for (const auto& watcher : watchers_) watcher();
    }

  private:
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
