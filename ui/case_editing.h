// SPDX-License-Identifier: GPL-3.0-or-later
// From clicks to corrections: what a click on a vessel or on a gap means with the tool that is
// chosen, and the panel that shows what was corrected. The corrections themselves are the
// workspace's.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/patient/corrections.h"
#include "render/bridge_actor.h"
#include "ui/background_job.h"
#include "ui/edit_panel.h"
#include "ui/slices/vessel_pen.h"
#include "ui/workspace.h"

namespace hepatica {

// UI thread; panel and workspace must outlive it.
class CaseEditing {
  public:
    struct Callbacks {
        std::function<void(const TreeEdit&)> add;
        std::function<void()> undo;
        std::function<void()> redo;
        // What they would take back and do again; empty: nothing.
        std::function<void(const QString& undo, const QString& redo)> show_history;
        std::function<void(std::vector<BridgeView>)> show_bridges;
        std::function<void(const QString&)> say;
        std::function<void(const Failure&)> not_drawn;
        std::function<void(const QString&)> warn;  // of what a correction made doubtful
    };
    CaseEditing(EditPanel& panel, const Workspace& workspace, Callbacks callbacks);

    // Another body is shown.
    void show_body();
    // Other corrections are wanted.
    void update_panel();

    // A click on a vessel in edit mode.
    void click(const TreePoint& point);
    // A click on a place of the CT, which must lie in a vessel or within 2 mm of its wall.
    void click_at(const Vec3& place_mm);
    // What a click does, for somebody who does not see the panel.
    QString tool_name() const { return panel_.tool_name(); }
    void accept(int bridge);
    // A vessel was drawn through these places of the patient's CT: it is followed beside the
    // window. What was being drawn before ends unanswered.
    void draw(const Volume& ct, const std::vector<Vec3>& places_mm,
              const VesselPen::Answered& answered);
    void stop_drawing() { drawing_.reset(); }

  private:
    void add_drawn(const TreeEdit& edit, const VesselPen::Answered& answered);
    void choose_bridge(int bridge);
    void accept_all();
    // Lists and draws the gaps that are still to be decided and of enough confidence.
    void show_bridges();
    void warn_of_new_doubts();

    EditPanel& panel_;
    const Workspace& workspace_;
    Callbacks callbacks_;
    std::vector<Bridge> bridges_;  // that are shown, best first
    double least_confidence_ = 0.0;
    std::optional<Vec3> link_from_mm_;
    std::vector<std::string> doubts_;  // of the body that is shown
    int loops_ = 0;                    // in it
    std::unique_ptr<BackgroundJob> drawing_;
};

}  // namespace hepatica
