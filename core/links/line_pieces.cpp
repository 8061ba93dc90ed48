// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the links of the skeleton's graph evenly and records which pieces meet.
#include "core/links/line_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/tree/extraction/skeleton_graph.h"

namespace hepatica {

namespace {

// The indices of a link's points at which it is cut, both ends included, about evenly spaced.
std::vector<std::size_t> cuts_of(const VesselLink& link, double longest_mm) {
    const double length = length_mm(link);
    const std::size_t steps = link.points_mm.size() - 1;
    const std::size_t parts =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(length / longest_mm)), 1, steps);
    std::vector<std::size_t> cuts{0};
    double along = 0.0;
    for (std::size_t i = 1; i < steps && cuts.size() < parts; ++i) {
        along += (link.points_mm[i] - link.points_mm[i - 1]).norm();
        if (along >= length * static_cast<double>(cuts.size()) / static_cast<double>(parts))
            cuts.push_back(i);
    }
    cuts.push_back(steps);
    return cuts;
}

void append_pieces(const VesselLink& link, double longest_mm, std::vector<LinePiece>& pieces) {
    const std::vector<std::size_t> cuts = cuts_of(link, longest_mm);
    for (std::size_t k = 1; k < cuts.size(); ++k) {
        LinePiece piece;
        for (std::size_t i = cuts[k - 1]; i <= cuts[k]; ++i) {
            piece.points_mm.push_back(link.points_mm[i]);
            piece.radii_mm.push_back(link.radii_mm[i]);
            if (i > cuts[k - 1])
                piece.length_mm += (link.points_mm[i] - link.points_mm[i - 1]).norm();
        }
        piece.link_length_mm = length_mm(link);
        pieces.push_back(std::move(piece));
    }
}

void join(std::vector<LinePiece>& pieces, int a, int b) {
    if (a == b) return;
    pieces[a].neighbours.push_back(b);
    pieces[b].neighbours.push_back(a);
}

}  // namespace

std::vector<LinePiece> line_pieces(const Mask& skeleton, const Mask& vessels, double longest_mm) {
    const VesselGraph graph = skeleton_graph(skeleton, vessels);
    std::vector<LinePiece> pieces;
    std::vector<std::vector<int>> of_node(graph.nodes.size());
    for (const VesselLink& link : graph.links) {
        const auto first = static_cast<int>(pieces.size());
        append_pieces(link, longest_mm, pieces);
        const int last = static_cast<int>(pieces.size()) - 1;
        for (int i = first; i < last; ++i) join(pieces, i, i + 1);
        of_node[link.from].push_back(first);
        of_node[link.to].push_back(last);
    }
    for (const std::vector<int>& meeting : of_node) {
        if (meeting.size() == 1) ++pieces[meeting[0]].free_ends;
        for (std::size_t i = 0; i < meeting.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) join(pieces, meeting[i], meeting[k]);
    }
    for (LinePiece& piece : pieces) {
        std::ranges::sort(piece.neighbours);
        piece.neighbours.erase(std::unique(piece.neighbours.begin(), piece.neighbours.end()),
                               piece.neighbours.end());
    }
    return pieces;
}

std::vector<int> components_of(const std::vector<LinePiece>& pieces) {
    std::vector<int> component(pieces.size(), -1);
    int count = 0;
    for (std::size_t start = 0; start < pieces.size(); ++start) {
        if (component[start] >= 0) continue;
        std::vector<int> waiting{static_cast<int>(start)};
        component[start] = count;
        while (!waiting.empty()) {
            const int at = waiting.back();
            waiting.pop_back();
            for (const int next : pieces[at].neighbours) {
                if (component[next] >= 0) continue;
                component[next] = count;
                waiting.push_back(next);
            }
        }
        ++count;
    }
    return component;
}

}  // namespace hepatica
