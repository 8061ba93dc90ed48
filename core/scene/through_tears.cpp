// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/through_tears.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/scene/origins_of.h"

namespace hepatica {
namespace {

int most_common(const std::map<int, int>& counts) {
    return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })
        ->first;
}

double radius_at(const VesselSegment& segment, double arclength_mm) {
    double left = arclength_mm;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        left -= (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
        if (left <= 0.0) return segment.radii_mm[i];
    }
    return segment.radii_mm.back();
}

// One entry per stretch of a segment, ascending: its tetrahedra.
using Sections = std::map<int, std::vector<int>>;

// What of the tree is looked at: segments with split vertices, and forks with one of these.
struct Looked {
    std::vector<std::uint8_t> segments, forks;  // a fork by the segment that ends there
    std::vector<Sections> along;                // empty where nothing is looked at
};

Looked looked_at(const std::vector<std::vector<int>>& branches, const TornTopology& topology,
                 std::span<const VertexPlace> tetrahedra, double stretch_mm) {
    Looked looked{std::vector<std::uint8_t>(branches.size(), 0), {}, {}};
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (const int corner : topology.tetrahedra()[t])
            if (topology.parents()[static_cast<std::size_t>(corner)] != corner)
                looked.segments[static_cast<std::size_t>(tetrahedra[t].on_tree.segment)] = 1;
    looked.forks = looked.segments;
    for (std::size_t s = 0; s < branches.size(); ++s)
        for (const int b : branches[s])
            if (looked.segments[static_cast<std::size_t>(b)] != 0) looked.forks[s] = 1;
    std::vector<std::uint8_t> needed = looked.forks;
    for (std::size_t s = 0; s < branches.size(); ++s)
        if (looked.forks[s] != 0)
            for (const int b : branches[s]) needed[static_cast<std::size_t>(b)] = 1;
    looked.along.resize(branches.size());
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        const TreePoint& at = tetrahedra[t].on_tree;
        const auto s = static_cast<std::size_t>(at.segment);
        if (needed[s] != 0)
            looked.along[s][static_cast<int>(at.arclength_mm / stretch_mm)].push_back(
                static_cast<int>(t));
    }
    return looked;
}

// Tells which tetrahedra of a part of the body are connected by vertices within that part. Not by
// way of the rest of the body: where two branches touch, it may lead around a cut.
class LocalPieces {
  public:
    // `vertices`: for each vertex of the body, the one that it counts as.
    LocalPieces(std::span<const std::array<int, 4>> tetrahedra, std::vector<int> vertices)
        : tetrahedra_(tetrahedra),
          vertices_(std::move(vertices)),
          number_(vertices_.size(), -1),
          pieces_(tetrahedra.size(), -1) {}

    // One number per piece, by tetrahedron; valid for those of the part, until the next call.
    std::span<const int> among(const std::vector<int>& part) {
        DisjointSets sets;
        const auto number_of = [&](int vertex) {
            int& number = number_[static_cast<std::size_t>(counts_as(vertex))];
            if (number < 0) number = static_cast<int>(sets.add());
            return static_cast<std::uint32_t>(number);
        };
        const auto corners_of = [&](int t) { return tetrahedra_[static_cast<std::size_t>(t)]; };
        for (const int t : part)
            for (const int corner : corners_of(t))
                sets.unite(number_of(corners_of(t)[0]), number_of(corner));
        for (const int t : part)
            pieces_[static_cast<std::size_t>(t)] =
                static_cast<int>(sets.root(number_of(corners_of(t)[0])));
        for (const int t : part)
            for (const int corner : corners_of(t))
                number_[static_cast<std::size_t>(counts_as(corner))] = -1;
        return pieces_;
    }

  private:
    int counts_as(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }

    std::span<const std::array<int, 4>> tetrahedra_;
    std::vector<int> vertices_;
    std::vector<int> number_, pieces_;
};

// The body as it is: vertices that ties hold together count as one.
std::vector<int> tied_vertices(const Tearing& tearing) {
    DisjointSets sets(static_cast<std::size_t>(tearing.topology().vertex_count()));
    for (const auto& [a, b] : tearing.bound_pairs())
        sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    std::vector<int> first(sets.size());
    for (std::size_t v = 0; v < first.size(); ++v)
        first[v] = static_cast<int>(sets.root(static_cast<std::uint32_t>(v)));
    return first;
}

std::vector<int> all_of(const Sections& sections) {
    std::vector<int> all;
    for (const auto& [stretch, members] : sections)
        all.insert(all.end(), members.begin(), members.end());
    return all;
}

// The end of one segment and the beginnings of its branches: two sections of each.
std::vector<int> around_fork(const std::vector<Sections>& along, std::size_t parent,
                             const std::vector<int>& branches) {
    constexpr std::size_t near = 2;
    std::vector<int> part;
    const auto add = [&](auto section, auto end) {
        for (std::size_t n = 0; n < near && section != end; ++n, ++section)
            part.insert(part.end(), section->second.begin(), section->second.end());
    };
    add(along[parent].rbegin(), along[parent].rend());
    for (const int b : branches) {
        const Sections& branch = along[static_cast<std::size_t>(b)];
        add(branch.begin(), branch.end());
    }
    return part;
}

// The pieces of a part of the body, before anything tore and now, by tetrahedron.
struct PiecesOfPart {
    std::span<const int> whole, now;

    // The piece as it was that most tetrahedra of a section belong to.
    int most_whole(const std::vector<int>& section) const { return most_of(section, whole); }
    // The piece now that most of the section's tetrahedra of `of_whole` belong to; -1: it has none.
    int most_now(std::vector<int> section, int of_whole) const {
        std::erase_if(section,
                      [&](int t) { return whole[static_cast<std::size_t>(t)] != of_whole; });
        return section.empty() ? -1 : most_of(section, now);
    }

  private:
    static int most_of(const std::vector<int>& section, std::span<const int> piece) {
        std::map<int, int> counts;
        for (const int t : section) ++counts[piece[static_cast<std::size_t>(t)]];
        return most_common(counts);
    }
};

// The stretches of a segment that no longer hang together with the stretch before. Those that never
// did, of meshes of several pieces, are left out.
std::vector<int> parted_stretches(const Sections& sections, const PiecesOfPart& pieces) {
    std::vector<int> found;
    if (sections.empty()) return found;
    const int whole = pieces.most_whole(all_of(sections));
    int before = -1;
    for (const auto& [stretch, members] : sections) {
        const int now = pieces.most_now(members, whole);
        if (now < 0) continue;
        if (before >= 0 && now != before) found.push_back(stretch);
        before = now;
    }
    return found;
}

}  // namespace

double lumen_mm2(const VesselSegment& segment, double arclength_mm) {
    const double radius = radius_at(segment, arclength_mm);
    return std::numbers::pi * radius * radius;
}

std::vector<ThroughTear> through_tears(const VesselTree& tree, const Tearing& tearing,
                                       std::span<const VertexPlace> tetrahedra, double stretch_mm) {
    std::vector<ThroughTear> found;
    if (tearing.report().vertices_split == 0) return found;
    const std::vector<std::vector<int>> branches = children(tree);
    const Looked looked = looked_at(branches, tearing.topology(), tetrahedra, stretch_mm);
    const std::vector<Sections>& along = looked.along;
    // The body as it was before anything tore.
    LocalPieces whole(tearing.topology().tetrahedra(), origins_of(tearing.topology()));
    LocalPieces now(tearing.topology().tetrahedra(), tied_vertices(tearing));
    const auto pieces_of = [&](const std::vector<int>& part) {
        return PiecesOfPart{whole.among(part), now.among(part)};
    };
    const auto add = [&](std::size_t s, double arclength_mm) {
        found.push_back(
            {{static_cast<int>(s), arclength_mm, 0.0}, lumen_mm2(tree.segments[s], arclength_mm)});
    };
    const auto add_at_fork = [&](std::size_t s) {
        const PiecesOfPart pieces = pieces_of(around_fork(along, s, branches[s]));
        const std::vector<int>& last = along[s].rbegin()->second;
        const int of_whole = pieces.most_whole(last);
        const int before = pieces.most_now(last, of_whole);
        std::map<int, int> piece_of;  // the piece of each branch
        for (const int b : branches[s]) {
            const Sections& branch = along[static_cast<std::size_t>(b)];
            if (branch.empty()) continue;
            const int first = pieces.most_now(branch.begin()->second, of_whole);
            if (first >= 0) piece_of[b] = first;
        }
        // Parted from the parent together, they go on feeding each other.
        const bool one_piece = std::ranges::all_of(piece_of, [&](const auto& branch) {
            return branch.second == piece_of.begin()->second;
        });
        if (piece_of.size() > 1 && one_piece && piece_of.begin()->second != before) {
            add(s, length_mm(tree.segments[s]));
            return;
        }
        for (const auto& [b, piece] : piece_of)
            if (piece != before)
                add(static_cast<std::size_t>(b),
                    along[static_cast<std::size_t>(b)].begin()->first * stretch_mm);
    };
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        if (looked.segments[s] != 0)
            for (const int stretch : parted_stretches(along[s], pieces_of(all_of(along[s]))))
                add(s, stretch * stretch_mm);
        if (looked.forks[s] != 0 && !along[s].empty()) add_at_fork(s);
    }
    return found;
}

}  // namespace hepatica
