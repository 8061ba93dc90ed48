// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a lesson's scene put in and taken out one by one. What is taken out keeps its
// settings, which no page of the editor may show, until it is put in again.
#pragma once

#include <functional>

#include "core/scene/scene_spec.h"

namespace hepatica {

// One for a lesson that is being edited. Taking a part out and putting it in again, or the other
// way round, leaves the scene as it was.
class SceneParts {
  public:
    void set_moves(SceneSpec& scene, bool on);      // and what needs it
    void set_touches(SceneSpec& scene, bool on);    // tools and vessels; needs what moves
    void set_self(SceneSpec& scene, bool on);       // vessels and vessels; needs what moves
    void set_obstacles(SceneSpec& scene, bool on);  // vessels and organs; needs what moves
    void set_tears(SceneSpec& scene, bool on);      // needs what moves
    void set_flows(SceneSpec& scene, bool on);
    // Of another lesson from now on.
    void forget() { *this = SceneParts(); }

  private:
    void set_contact(SceneSpec& scene, bool on, const std::function<void(ContactSpec&)>& change);

    SceneSpec with_moving_{};  // what was taken out with it: deform, contact, tear
    bool moving_taken_ = false;
    std::optional<TearSpec> tear_;
    std::optional<FlowSpec> flow_;
    WantedObstacles obstacles_ = WantedObstacles::required;
    double friction_ = 0.0;       // of vessels that touch each other
    bool empty_contact_ = false;  // the scene named contact, of nothing
};

}  // namespace hepatica
