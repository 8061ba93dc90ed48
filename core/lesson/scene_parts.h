// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts and removes the parts of a lesson's scene in the editor. A removed part keeps its
// settings until it is inserted again, including those that no page of the editor shows.
#pragma once

#include <functional>

#include "core/scene/scene_spec.h"

namespace hepatica {

// One per edited lesson. Removing and inserting a part, in either order, restores the scene.
class SceneParts {
  public:
    void set_moves(SceneSpec& scene, bool on);      // and all that needs motion
    void set_touches(SceneSpec& scene, bool on);    // contact of tools; needs motion
    void set_self(SceneSpec& scene, bool on);       // self-contact; needs motion
    void set_obstacles(SceneSpec& scene, bool on);  // contact with organs; needs motion
    void set_tears(SceneSpec& scene, bool on);      // needs motion
    void set_flows(SceneSpec& scene, bool on);
    // Call when another lesson is edited.
    void forget() { *this = SceneParts(); }

  private:
    void set_contact(SceneSpec& scene, bool on, const std::function<void(ContactSpec&)>& change);

    SceneSpec with_moving_{};  // removed parts: deform, contact, tear
    bool moving_taken_ = false;
    std::optional<TearSpec> tear_;
    std::optional<FlowSpec> flow_;
    WantedObstacles obstacles_ = WantedObstacles::required;
    double friction_ = 0.0;       // of self-contact
    bool empty_contact_ = false;  // the scene had a contact part with nothing in it
};

}  // namespace hepatica
