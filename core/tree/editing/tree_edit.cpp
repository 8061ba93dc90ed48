// SPDX-License-Identifier: GPL-3.0-or-later
// Applies edits to the tree's graph, and directs the result from the roots that the tree had.
#include "core/tree/editing/tree_edit.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/editing/drawn_vessel.h"
#include "core/tree/editing/edit_reach.h"
#include "core/tree/editing/system_seed.h"
#include "core/tree/extraction/bridged_points.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/cut_gap.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

namespace {

// Confidence of a system stated by the user.
double confidence_by_hand(VascularSystem system) {
    return system == VascularSystem::unknown ? 0.0 : 1.0;
}

TreePoint locate(const VesselTree& tree, const Vec3& position_mm) {
    const TreePoint found = nearest_point(tree, position_mm);
    if (!(found.distance_mm <= edit_reach_mm))
        throw InputError("no vessel within 10 mm", place_text(position_mm),
                         "Name a place on a vessel");
    return found;
}

// Merges nodes at one position, so that a vessel that changes its system is connected to what it
// touches.
void merge_touching_nodes(VesselGraph& graph, std::vector<RootWish>& wishes) {
    std::map<std::tuple<double, double, double>, int> first_at;
    std::vector<int> merged(graph.nodes.size());
    for (std::size_t n = 0; n < merged.size(); ++n) {
        const Vec3& p = graph.nodes[n].position_mm;
        merged[n] = first_at.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(n)).first->second;
    }
    for (VesselLink& link : graph.links) {
        link.from = merged[link.from];
        link.to = merged[link.to];
    }
    for (RootWish& wish : wishes) wish.node = merged[wish.node];
}

class Edit {
  public:
    explicit Edit(const VesselTree& tree)
        : tree_(tree), graph_(to_graph(tree)), wishes_(root_wishes(tree)) {
        bridged_.add(tree);
    }

    void cut(const TreeEdit& edit) {
        const TreePoint at = locate(tree_, edit.at_mm);
        const auto stretch = cut_stretch(graph_, at.segment, at.arclength_mm);
        if (!stretch)
            throw InputError("the vessel is too short here to be parted by a gap of 1 mm",
                             place_text(edit.at_mm), "Cut a longer one beside it, or delete it");
        int taken = at.segment;
        if (stretch->to_mm) split_link(graph_, taken, *stretch->to_mm, 0.0);
        // The part beyond the cut begins at the cut, unless it has a root already.
        wishes_.push_back({graph_.links[taken].to, graph_.links[taken].system});
        if (stretch->from_mm) {
            split_link(graph_, taken, *stretch->from_mm, 0.0);
            taken = static_cast<int>(graph_.links.size()) - 1;
        }
        graph_.links.erase(graph_.links.begin() + taken);
    }

    void add(const TreeEdit& edit) {
        const auto node_at = [&](const Vec3& position_mm) {
            // Located in the current graph: the first split may have renumbered its links.
            const TreePoint at = locate({{}, segments_of(graph_)}, position_mm);
            // Read before the split, which may move the links.
            const VascularSystem system = graph_.links[at.segment].system;
            return std::pair(split_link(graph_, at.segment, at.arclength_mm, 1.0), system);
        };
        const auto [from, system] = node_at(edit.at_mm);
        const auto [to, other_system] = node_at(edit.to_mm);
        // Each of two systems that touch has a node of its own there.
        if (from == to || graph_.nodes[from].position_mm == graph_.nodes[to].position_mm)
            throw InputError("both ends of the link lie at one point", place_text(edit.at_mm),
                             "Name two places that are not joined yet");
        add_path(from, to, system, edit.path_mm);
        share_system(from, system, to, other_system);
    }

    void remove_branch(const TreeEdit& edit) {
        const auto hangs = downstream_of(tree_, locate(tree_, edit.at_mm).segment);
        remove_links(graph_, hangs);
    }

    // All that hangs together: in a ring without ends the segment that closes it has no parent.
    void remove_tree(const TreeEdit& edit) {
        const std::vector<int> component = component_of_nodes(graph_);
        const int gone = component[graph_.links[locate(tree_, edit.at_mm).segment].from];
        std::erase_if(graph_.links,
                      [&](const VesselLink& link) { return component[link.from] == gone; });
    }

    void set_root(const TreeEdit& edit) {
        const int near = locate(tree_, edit.at_mm).segment;
        const std::vector<int> component = component_of_nodes(graph_);
        const auto at_node = links_of_nodes(graph_);
        const int wanted = component[tree_.segments[near].proximal_node];
        int best = tree_.segments[near].proximal_node;
        double least = edit_reach_mm * 1e6;
        for (std::size_t n = 0; n < component.size(); ++n) {
            const double d = (graph_.nodes[n].position_mm - edit.at_mm).norm();
            if (component[n] != wanted || at_node[n].size() != 1 || d >= least) continue;
            least = d;
            best = static_cast<int>(n);
        }
        wishes_.insert(wishes_.begin(), RootWish{best, tree_.segments[near].system});
    }

    void reassign(const TreeEdit& edit) {
        const int first = locate(tree_, edit.at_mm).segment;
        const auto hangs = downstream_of(tree_, first);
        for (std::size_t i = 0; i < hangs.size(); ++i)
            if (hangs[i] != 0) {
                graph_.links[i].system = edit.system;
                graph_.links[i].system_confidence = confidence_by_hand(edit.system);
            }
        merge_touching_nodes(graph_, wishes_);
        // A part that touches no vessel of its new system begins where it was attached before.
        wishes_.push_back({graph_.links[first].from, edit.system});
    }

    void seed(const TreeEdit& edit) {
        const TreePoint at = locate(tree_, edit.at_mm);
        merge_touching_nodes(graph_, wishes_);
        SeededGraph seeded = seeded_graph(tree_, graph_, {edit.at_mm, at, edit.system});
        keep_roots();
        // A part that touches no vessel of its new system begins where it was attached before.
        root_places_.emplace_back(seeded.begin_mm, edit.system);
        graph_ = std::move(seeded.graph);
    }

    void draw(const TreeEdit& edit) {
        const DrawnVessel drawn =
            add_drawn_vessel(graph_, {edit.path_mm, edit.radii_mm}, edit.system);
        if (!drawn.grows_out || !drawn.leads_in || drawn.system_at_to == drawn.system) return;
        // A click that is merely near another vessel must not change that vessel's whole system.
        if (drawn.system != VascularSystem::unknown &&
            drawn.system_at_to != VascularSystem::unknown)
            throw InputError("the vessel would join two systems: " + title_of(drawn.system) +
                                 " and " + title_of(drawn.system_at_to),
                             place_text(edit.path_mm.back()),
                             "End it before the other vessel's wall, or say first of which system "
                             "that vessel is");
        share_system(drawn.from, drawn.system, drawn.to, drawn.system_at_to);
    }

    VesselTree result() {
        keep_roots();
        const std::vector<RootPlace> middle = roots_that_stay_in_the_middle();
        part_at(middle);
        join_passing_nodes(graph_);
        unite_at(middle);
        VesselTree tree = directed(std::move(graph_), wishes_at_places());
        bridged_.mark(tree);
        return tree;
    }

  private:
    using RootPlace = std::pair<Vec3, VascularSystem>;

    // Keeps roots by position, because nodes may be renumbered.
    void keep_roots() {
        for (const RootWish& wish : wishes_)
            root_places_.emplace_back(graph_.nodes[wish.node].position_mm, wish.system);
        wishes_.clear();
    }

    std::vector<RootWish> wishes_at_places() const {
        std::vector<RootWish> wishes;
        for (const auto& [place, system] : root_places_)
            for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
                if (graph_.nodes[n].position_mm == place)
                    wishes.push_back({static_cast<int>(n), system});
        return wishes;
    }

    // The roots of the tree at which several segments begin, and which the edits have left roots.
    // Such a node of two segments, as where both branches of a fork were given to another system
    // than the trunk, looks like the middle of a vessel: joined there, the root would move to an
    // end.
    std::vector<RootPlace> roots_that_stay_in_the_middle() const {
        std::map<int, int> begin_at;
        for (const int id : roots(tree_)) ++begin_at[tree_.segments[id].proximal_node];
        std::erase_if(begin_at, [](const auto& entry) { return entry.second < 2; });
        std::vector<RootPlace> stay;
        if (begin_at.empty()) return stay;
        const VesselTree after = directed(graph_, wishes_at_places());
        for (const int id : roots(tree_)) {
            const VesselSegment& root = tree_.segments[id];
            const RootPlace place(tree_.nodes[root.proximal_node].position_mm, root.system);
            const bool is_root = std::ranges::any_of(roots(after), [&](int other) {
                const VesselSegment& begins = after.segments[other];
                return begins.system == place.second &&
                       after.nodes[begins.proximal_node].position_mm == place.first;
            });
            if (is_root && begin_at.contains(root.proximal_node) &&
                std::ranges::find(stay, place) == stay.end())
                stay.push_back(place);
        }
        return stay;
    }

    // Gives one of the two links there a node of its own, so that nothing passes through.
    void part_at(const std::vector<RootPlace>& places) {
        const auto at_node = links_of_nodes(graph_);
        for (std::size_t n = 0; n < at_node.size(); ++n) {
            const RootPlace here(
                graph_.nodes[n].position_mm,
                at_node[n].empty() ? VascularSystem::unknown : graph_.links[at_node[n][0]].system);
            if (at_node[n].size() != 2 || std::ranges::find(places, here) == places.end()) continue;
            VesselLink& second = graph_.links[at_node[n][1]];
            const int own = static_cast<int>(graph_.nodes.size());
            (second.from == static_cast<int>(n) ? second.from : second.to) = own;
            graph_.nodes.push_back(VesselNode(graph_.nodes[n]));
        }
    }

    void unite_at(const std::vector<RootPlace>& places) {
        std::vector<int> first(places.size(), -1);
        const auto unite = [&](int& node, VascularSystem system) {
            const auto place =
                std::ranges::find(places, RootPlace(graph_.nodes[node].position_mm, system));
            if (place == places.end()) return;
            int& kept = first[static_cast<std::size_t>(place - places.begin())];
            if (kept < 0) kept = node;
            node = kept;
        };
        for (VesselLink& link : graph_.links) {
            unite(link.from, link.system);
            unite(link.to, link.system);
        }
    }

    void add_path(int from, int to, VascularSystem system, const std::vector<Vec3>& between_mm) {
        const VesselNode& start = graph_.nodes[from];
        const VesselNode& end = graph_.nodes[to];
        Centreline curve{{start.position_mm}, {start.radius_mm}};
        for (const Vec3& p : between_mm)
            if (p != curve.points_mm.back() && p != end.position_mm) curve.points_mm.push_back(p);
        curve.points_mm.push_back(end.position_mm);
        const std::vector<double> at = arclengths_mm(curve.points_mm);
        // A link is no wider than the narrower of the two vessels it joins.
        const double radius = std::min(start.radius_mm, end.radius_mm);
        curve.radii_mm.assign(at.size(), radius);
        curve = resampled(curve, std::max(0.5 * radius, 0.5));
        bridged_.add(curve.points_mm);
        graph_.links.push_back(
            {from, to, system, confidence_by_hand(system), curve.points_mm, curve.radii_mm});
    }

    // The vessel at `to` takes the system of the one at `from`. Where that one's is unknown, it is
    // the other way round: a piece without a system must not take that of a whole tree away.
    void share_system(int from, VascularSystem system, int to, VascularSystem other_system) {
        if (system == other_system) return;
        if (system == VascularSystem::unknown)
            adopt(from, other_system, system);
        else
            adopt(to, system, other_system);
    }

    // Gives `system` to the vessels of the old system that are connected to the node.
    void adopt(int node, VascularSystem system, VascularSystem old_system) {
        const auto at_node = links_of_nodes(graph_);
        std::vector<int> open{node};
        while (!open.empty()) {
            const int n = open.back();
            open.pop_back();
            for (const int id : at_node[n]) {
                VesselLink& link = graph_.links[id];
                if (link.system != old_system) continue;
                link.system = system;
                link.system_confidence = 0.0;
                open.push_back(link.from);
                open.push_back(link.to);
            }
        }
    }

    const VesselTree& tree_;
    VesselGraph graph_;
    std::vector<RootWish> wishes_;
    std::vector<RootPlace> root_places_;
    BridgedPoints bridged_;
};

}  // namespace

VesselTree edited(const VesselTree& tree, const TreeEdit& edit) {
    if (!changes_tree(edit.kind)) return tree;
    Edit work(tree);
    switch (edit.kind) {
        case TreeEditKind::cut_link:
            work.cut(edit);
            break;
        case TreeEditKind::add_link:
            work.add(edit);
            break;
        case TreeEditKind::delete_branch:
            work.remove_branch(edit);
            break;
        case TreeEditKind::delete_tree:
            work.remove_tree(edit);
            break;
        case TreeEditKind::set_root:
            work.set_root(edit);
            break;
        case TreeEditKind::reassign_system:
            work.reassign(edit);
            break;
        case TreeEditKind::seed_system:
            work.seed(edit);
            break;
        case TreeEditKind::draw_vessel:
            work.draw(edit);
            break;
        case TreeEditKind::paint_tumour:
        case TreeEditKind::erase_tumour:
        case TreeEditKind::refuse_gap:
            break;  // does not change the tree
    }
    return work.result();
}

TreeEdit drawing_of(Centreline traced, VascularSystem system) {
    TreeEdit edit;
    edit.kind = TreeEditKind::draw_vessel;
    edit.at_mm = traced.points_mm.front();
    edit.path_mm = std::move(traced.points_mm);
    edit.radii_mm = std::move(traced.radii_mm);
    edit.system = system;
    return edit;
}

TreeEditor::TreeEditor(VesselTree tree) {
    states_.push_back(std::move(tree));
}

void TreeEditor::apply(const TreeEdit& edit) {
    VesselTree next = edited(tree(), edit);
    states_.resize(done_ + 1);
    edits_.resize(done_);
    states_.push_back(std::move(next));
    edits_.push_back(edit);
    ++done_;
}

void TreeEditor::undo() {
    if (can_undo()) --done_;
}

void TreeEditor::redo() {
    if (can_redo()) ++done_;
}

std::vector<TreeEdit> TreeEditor::edits() const {
    return {edits_.begin(), edits_.begin() + static_cast<std::ptrdiff_t>(done_)};
}

}  // namespace hepatica
