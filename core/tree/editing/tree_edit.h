// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand: commands that can be undone and are stored with the case. They refer to
// positions, not to segment numbers, so that they stay valid after other edits. All but the brush
// strokes on tumours and the refusal of a gap change the vessel tree.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/tree/extraction/centreline.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

enum class TreeEditKind {
    cut_link,         // cuts the vessel at `at_mm`, with 1 mm between the walls; the part beyond
                      // becomes a tree of its own
    add_link,         // joins the vessels nearest to `at_mm` and `to_mm`
    delete_branch,    // removes the segment at `at_mm` and all downstream of it
    delete_tree,      // removes the whole tree at `at_mm`
    set_root,         // makes the end nearest to `at_mm` the root of its component
    reassign_system,  // gives the segment at `at_mm` and all downstream of it to `system`
    seed_system,      // states the system of the vessel at `at_mm`; all downstream follows, and
                      // upstream as much as a minimal cut gives (seeded_spread.h)
    draw_vessel,      // adds the vessel along `path_mm` (drawn_vessel.h), beginning at `at_mm`; one
                      // that touches no other has its root there
    paint_tumour,     // a ball moved along `path_mm` turns voxels into `tumour`
    erase_tumour,     // removes them from it
    refuse_gap,       // the gap between `at_mm` and `to_mm` is not to be bridged: it is offered no
                      // more
};

constexpr bool is_tumour_stroke(TreeEditKind kind) {
    return kind == TreeEditKind::paint_tumour || kind == TreeEditKind::erase_tumour;
}

// False for edits that leave the tree as it is.
constexpr bool changes_tree(TreeEditKind kind) {
    return !is_tumour_stroke(kind) && kind != TreeEditKind::refuse_gap;
}

struct TreeEdit {
    TreeEditKind kind = TreeEditKind::cut_link;
    Vec3 at_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();  // add_link, refuse_gap
    // add_link: points between the two vessels; empty: straight. draw_vessel: the centreline, two
    // points or more. Strokes: the path of the ball.
    std::vector<Vec3> path_mm;
    // reassign_system, seed_system: the new system. draw_vessel: the system where it touches no
    // vessel.
    VascularSystem system = VascularSystem::unknown;
    // draw_vessel: one per point of the path, above 0. Strokes: the radius of the ball.
    std::vector<double> radii_mm;
    // paint_tumour: number, 1 to most_tumours. erase_tumour: number, or 0 for all tumours.
    int tumour = 0;
    // Neighbours in a list with the same number above 0 were made by one deed, and are taken back
    // and made again together.
    int step = 0;

    bool operator==(const TreeEdit&) const = default;
};

inline constexpr int most_tumours = 246;  // largest number of tumours: labels fit into a byte

inline constexpr int most_steps = 1'000'000;  // greatest number of a step

// The number of another step after these edits: one more than their greatest, or 1 after the
// greatest that there is.
inline int next_step(std::span<const TreeEdit> edits) {
    int last = 0;
    for (const TreeEdit& edit : edits) last = std::max(last, edit.step);
    return last % most_steps + 1;
}

inline bool of_one_step(const TreeEdit& edit, const TreeEdit& next) {
    return edit.step != 0 && edit.step == next.step;
}

// The tree after the edit. Throws InputError where the edit is not possible: an empty tree, a place
// more than 10 mm from any vessel, a link with both ends at one point, a cut where forks are too
// close for a gap, a seed for the system that the vessel has, a drawn vessel that lies in existing
// ones or would join two systems.
VesselTree edited(const VesselTree& tree, const TreeEdit& edit);

// A tree and the edits made to it. Keeps one tree per edit. Not thread-safe.
class TreeEditor {
  public:
    explicit TreeEditor(VesselTree tree);

    const VesselTree& tree() const { return states_[done_]; }
    // Applies an edit and forgets undone ones. Throws as edited() does, with nothing changed.
    void apply(const TreeEdit& edit);
    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < edits_.size(); }
    void undo();  // no effect where nothing can be undone
    void redo();
    // The edits that made the present tree, in order.
    std::vector<TreeEdit> edits() const;

  private:
    std::vector<VesselTree> states_;  // one more than edits
    std::vector<TreeEdit> edits_;
    std::size_t done_ = 0;
};

// A traced vessel (vessel_tracing.h) as an edit. `system` counts where it touches no vessel.
TreeEdit drawing_of(Centreline traced, VascularSystem system = VascularSystem::unknown);

// Edits as a JSON array, and back. Reading throws InputError, naming `place` (the file).
std::string edits_to_json(const std::vector<TreeEdit>& edits);
std::vector<TreeEdit> edits_from_json(const std::string& text, const std::string& place);

}  // namespace hepatica
