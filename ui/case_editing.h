// SPDX-License-Identifier: GPL-3.0-or-later
// Turns clicks on vessels and gaps into corrections, by the tool chosen in the panel, and fills the
// panel. The corrections are kept by the Workspace.
#pragma once

#include <QStringList>
#include <cstdint>
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

// UI thread only; panel and workspace must outlive it.
class CaseEditing {
  public:
    struct Callbacks {
        std::function<void(const TreeEdit&)> add;
        // Takes all that is offered with this confidence or more.
        std::function<void(double confidence)> accept_all;
        std::function<void()> undo;
        std::function<void()> redo;
        // What undo and redo would change, in words; empty: nothing.
        std::function<void(const QString& undo, const QString& redo)> show_history;
        // Whether undo takes back a point in the slices, before any correction; redo waits then.
        std::function<bool()> points_wait;
        std::function<void(std::vector<BridgeView>)> show_bridges;
        // The path of the bridge that is chosen, for the slices, where it is decided on; empty:
        // none is.
        std::function<void(const std::vector<Vec3>& path_mm)> look_at;
        std::function<void(const QString&)> say;
        std::function<void(const Failure&)> not_drawn;
        std::function<void(const QString&)> warn;  // what a correction made doubtful, in lines
        // A link just made may be a mistake, for what these lines say.
        std::function<void(const QString&, const TreeEdit& link)> warn_of_link;
        std::function<void()> link_changed;  // link_from_mm() has changed
        std::function<int()> chosen_branch;  // in the table of branches; -1: none
    };
    CaseEditing(EditPanel& panel, const Workspace& workspace, Callbacks callbacks);

    // Another body is shown.
    void show_body();
    // The list of corrections has changed.
    void update_panel();
    // What undo would change may be another step now.
    void show_history();

    // A click on a vessel in edit mode.
    void click(const TreePoint& point);
    // A click on a place of the CT (mm), which must lie in a vessel or within 2 mm of its wall.
    void click_at(const Vec3& place_mm);
    // What a click does, in words, for places where the panel is not visible.
    QString tool_name() const { return panel_.tool_name(); }
    // The first vessel of a link whose second one is still to be clicked on, mm.
    const std::optional<Vec3>& link_from_mm() const { return link_from_mm_; }
    // Whether what was warned of in this line is still so.
    bool stands(const QString& doubt) const;
    // A click on what is drawn as this view (BridgeView) of the scene. It takes it, but in Edit
    // mode, where a click does what the panel says and to vessels alone, it only chooses it there.
    void click_drawn(int view);
    // In Edit mode doubtful branches are drawn as well: there are too many of them for a play.
    void set_edit_mode(bool on);
    // Follows a vessel through these places of the patient's CT in the background. Without a radius
    // that is measured, too. A drawing that is still running ends without an answer.
    void draw(const Volume& ct, const std::vector<Vec3>& places_mm,
              const std::optional<double>& radius_mm, const VesselPen::Answered& answered);
    void stop_drawing() { drawing_.reset(); }

  private:
    // A vessel that was given to a system and is a tree of its own there.
    struct GivenApart {
        QString doubt;  // what was said of it
        VascularSystem system;
        Vec3 at_mm;                   // where it was given
        std::vector<Vec3> others_mm;  // in the system's other trees, as they were then
        bool still = true;            // of the shown body
    };
    static bool is_apart(const GivenApart& given, const VesselTree& tree);

    void click_chosen();
    void begin_link(const std::optional<Vec3>& from_mm);
    // `apart`: it touches no other vessel.
    void add_drawn(const TreeEdit& edit, bool apart, const VesselPen::Answered& answered);
    // Rows of the panel: built bridges, then offered ones.
    void accept(int row);
    void draw_bridges();
    void refuse(int row);
    const Bridge* bridge_of(int row) const;
    // The tree with all wanted corrections, whose body may still be made. Throws InputError where
    // one of them is not possible.
    PatientCase wanted() const;
    // Asks for the correction, unless it gives a vessel to the system that it surely has; says so,
    // and why a link may be a mistake.
    void add(const TreeEdit& edit);
    void warn_of_link(const TreeEdit& link, const std::vector<std::string>& doubts);
    // Lists what is undecided and has enough confidence, which is drawn, too, and what the
    // reconstruction built.
    void show_bridges();
    // What the wanted corrections leave undecided, best first, and built.
    struct Bridges {
        std::vector<Bridge> open, built;
    };
    Bridges bridges_now() const;
    void list_bridges(Bridges now);
    void warn_of_new_doubts();
    // A sentence for each system that was given a vessel which became a tree of its own there.
    QStringList given_apart();

    EditPanel& panel_;
    const Workspace& workspace_;
    Callbacks callbacks_;
    std::vector<Bridge> bridges_;     // offered in the panel, best first
    std::size_t bridges_listed_ = 0;  // how many were undecided then, with those of less confidence
    std::vector<Bridge> built_;       // listed behind them, the most doubtful first
    std::vector<int> drawn_;          // rows of what is drawn
    bool edit_mode_ = false;
    double least_confidence_ = 0.0;
    std::optional<Vec3> link_from_mm_;
    std::vector<std::string> doubts_;           // of the shown body
    std::vector<std::string> told_of_link_;     // before the body of the link was there
    int loops_ = 0;                             // number of loops among doubts_
    std::shared_ptr<const PatientCase> shown_;  // whose body is shown
    std::uint64_t origin_ = 0, opening_ = 0;    // of the workspace then
    std::vector<GivenApart> apart_;             // of this patient
    std::unique_ptr<BackgroundJob> drawing_;
};

}  // namespace hepatica
