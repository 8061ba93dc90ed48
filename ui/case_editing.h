// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of the patient that is shown: clicks and accepted bridges become a list of edits, whose
// body is made in the background and then shown. Until then the view shows the body before, and the
// panel says so.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/patient/corrections.h"
#include "render/bridge_actor.h"
#include "ui/edit_panel.h"

namespace hepatica {

// UI thread; the panel must outlive it.
class CaseEditing {
  public:
    struct Callbacks {
        // Makes the body of these edits; show() follows, or job_ended() alone where it fails.
        std::function<void(std::vector<TreeEdit>)> rebuild;
        std::function<void(std::vector<BridgeView>)> show_bridges;
        std::function<void(const QString&)> say;
    };
    CaseEditing(EditPanel& panel, Callbacks callbacks);

    // The patient whose body is shown now. `rebuilt`: it is the one before, with other edits.
    void show(std::shared_ptr<const PatientCase> patient, bool rebuilt);
    // What was asked for and has not been shown by now will not come.
    void job_ended();

    // A click on a vessel in edit mode.
    void click(const TreePoint& point);
    void accept(int bridge);
    void undo();
    void redo();

  private:
    void choose_bridge(int bridge);
    void want(std::vector<TreeEdit> edits);
    void add(const TreeEdit& edit);
    void update_panel();

    EditPanel& panel_;
    Callbacks callbacks_;
    std::shared_ptr<const PatientCase> patient_;
    std::vector<Bridge> bridges_;
    std::vector<TreeEdit> wanted_;  // the shown ones, or those that are being made
    std::vector<TreeEdit> undone_;  // the last one first to be done again
    std::optional<Vec3> link_from_mm_;
};

}  // namespace hepatica
