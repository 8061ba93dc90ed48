// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand: commands that can be undone and are stored with the case. They name places
// in the patient, not numbers of segments, so that they still mean the same after other edits. All
// but the strokes of a brush at tumours are of the vessel tree.
#pragma once

#include <string>
#include <vector>

#include "core/tree/extraction/centreline.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

enum class TreeEditKind {
    cut_link,         // parts the vessel at `at_mm`, wall from wall by 1 mm; what hangs there
                      // becomes a tree of its own
    add_link,         // joins the vessels nearest to `at_mm` and `to_mm`
    delete_branch,    // removes the segment at `at_mm` and all that hangs on it
    delete_tree,      // removes the whole tree at `at_mm`, from its root on
    set_root,         // makes the end nearest to `at_mm` the root of its component
    reassign_system,  // gives the segment at `at_mm` and all that hangs on it to `system`
    seed_system,      // says that the vessel at `at_mm` is of `system`: what hangs on it goes with
                      // it, and upstream as much as a minimal cut gives (seeded_spread.h)
    draw_vessel,      // adds the vessel along `path_mm` (drawn_vessel.h), which begins at `at_mm`;
                      // one that touches no other has its root there
    paint_tumour,     // a ball is led along `path_mm` through voxels that become `tumour`
    erase_tumour,     // or are of it no more
};

// False of the strokes at tumours, which leave the tree as it is.
constexpr bool changes_tree(TreeEditKind kind) {
    return kind != TreeEditKind::paint_tumour && kind != TreeEditKind::erase_tumour;
}

struct TreeEdit {
    TreeEditKind kind = TreeEditKind::cut_link;
    Vec3 at_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();  // add_link
    // add_link: points between the two vessels; empty: straight. draw_vessel: its centreline, two
    // points or more.
    std::vector<Vec3> path_mm;
    // reassign_system, seed_system; draw_vessel: where it touches no vessel that has one.
    VascularSystem system = VascularSystem::unknown;
    // draw_vessel: one per point of the path, above 0. paint_tumour, erase_tumour: that of the
    // ball.
    std::vector<double> radii_mm;
    // paint_tumour: its number, 1 to most_tumours. erase_tumour: likewise, or 0 for all of them.
    int tumour = 0;

    bool operator==(const TreeEdit&) const = default;
};

inline constexpr int most_tumours = 246;  // of a patient: their labels fit into a byte

// The tree after the edit. Throws InputError where the edit cannot be done (an empty tree, a place
// farther than 10 mm from any vessel, two ends of a link at one point, a cut between two forks too
// close for a gap, a vessel drawn where there is one).
VesselTree edited(const VesselTree& tree, const TreeEdit& edit);

// A tree and the edits made to it. Not thread-safe.
class TreeEditor {
  public:
    explicit TreeEditor(VesselTree tree);

    const VesselTree& tree() const { return states_[done_]; }
    // Does an edit; what had been undone before is forgotten. Throws as edited() does and then
    // leaves everything as it was.
    void apply(const TreeEdit& edit);
    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < edits_.size(); }
    void undo();  // does nothing where nothing can be undone
    void redo();
    // The edits that made the present tree, in order.
    std::vector<TreeEdit> edits() const;

  private:
    std::vector<VesselTree> states_;  // one more than edits
    std::vector<TreeEdit> edits_;
    std::size_t done_ = 0;
};

// The vessel that was traced (vessel_tracing.h) as an edit. `system` counts where it touches none.
TreeEdit drawing_of(Centreline traced, VascularSystem system = VascularSystem::unknown);

// Edits as a JSON array, and back. Reading throws InputError that names `place` (the file).
std::string edits_to_json(const std::vector<TreeEdit>& edits);
std::vector<TreeEdit> edits_from_json(const std::string& text, const std::string& place);

}  // namespace hepatica
