// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the surest way from kept pieces to each dropped one (Dijkstra's algorithm; a millimetre
// costs one minus its share of vessel), and divides the tree of these ways into branches.
#include "core/links/offered_branches.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double same_place_mm = 0.01;
constexpr double smoothing_mm = 1.0;  // deviation; against the staircase of the skeleton

bool is_same(const Vec3& a, const Vec3& b) {
    return (a - b).norm() < same_place_mm;
}

const Vec3& end_of(const LinePiece& piece, bool front) {
    return front ? piece.points_mm.front() : piece.points_mm.back();
}

// How a dropped piece is reached.
struct Way {
    double cost = std::numeric_limits<double>::infinity();
    int from = -1;           // the dropped piece before it; -1: a kept one
    bool from_front = true;  // its first point is where it is entered
    bool settled = false;
    bool leads_back = false;  // goes on to a kept piece: with that it would close a loop
};

class Ways {
  public:
    Ways(const std::vector<LinePiece>& pieces, const std::vector<double>& shares,
         const std::vector<std::uint8_t>& chosen)
        : pieces_(pieces), shares_(shares), chosen_(chosen), ways_(pieces.size()) {
        for (int piece = 0; piece < std::ssize(pieces_); ++piece) {
            if (chosen_[at(piece)] != 0) continue;
            // What meets kept pieces at both ends would close a loop.
            const bool front = meets_kept(piece, true);
            if (front != meets_kept(piece, false)) offer(piece, 0.0, -1, front);
        }
        spread();
    }

    // Ends of ways that do not go on, the one with the most vessel on its way first.
    std::vector<int> tips() const {
        std::vector<std::uint8_t> goes_on(pieces_.size(), 0);
        for (const Way& way : ways_)
            if (way.settled && way.from >= 0) goes_on[at(way.from)] = 1;
        std::vector<std::pair<double, int>> found;
        for (int piece = 0; piece < std::ssize(pieces_); ++piece) {
            const Way& way = ways_[at(piece)];
            if (!way.settled || way.leads_back || goes_on[at(piece)] != 0) continue;
            double vessel_mm = 0.0;
            for (int on = piece; on >= 0; on = ways_[at(on)].from)
                vessel_mm += pieces_[at(on)].length_mm * shares_[at(on)];
            found.emplace_back(-vessel_mm, piece);
        }
        std::ranges::sort(found);
        std::vector<int> tips(found.size());
        std::ranges::transform(found, tips.begin(), &std::pair<double, int>::second);
        return tips;
    }

    // The pieces from a tip back to a kept one or to one that a way before has taken; takes them.
    std::vector<int> take(int tip) {
        std::vector<int> chain;
        for (int piece = tip; piece >= 0 && !taken_[at(piece)]; piece = ways_[at(piece)].from)
            chain.push_back(piece);
        const auto sure = [this](int piece) { return shares_[at(piece)] >= least_offered_share; };
        chain.erase(chain.begin(), std::ranges::find_if(chain, sure));
        for (const int piece : chain) taken_[at(piece)] = true;
        std::ranges::reverse(chain);
        return chain;
    }

    Bridge branch_along(const std::vector<int>& chain) const {
        Bridge branch;
        double vessel_mm = 0.0, length_mm = 0.0;
        for (const int piece : chain) {
            append(piece, branch);
            length_mm += pieces_[at(piece)].length_mm;
            vessel_mm += pieces_[at(piece)].length_mm * shares_[at(piece)];
        }
        branch.radii_mm = smooth_values(branch.path_mm, branch.radii_mm, {}, smoothing_mm);
        branch.path_mm = smooth_curve(branch.path_mm, smoothing_mm, true);
        branch.from_radius_mm = branch.radii_mm.front();
        branch.to_radius_mm = branch.radii_mm.back();
        branch.gap_mm = length_mm;
        branch.confidence = vessel_mm / length_mm;
        return branch;
    }

  private:
    static std::size_t at(int piece) { return static_cast<std::size_t>(piece); }

    bool meets_kept(int piece, bool front) const {
        const Vec3& end_mm = end_of(pieces_[at(piece)], front);
        return std::ranges::any_of(pieces_[at(piece)].neighbours, [&](int next) {
            const LinePiece& other = pieces_[at(next)];
            return chosen_[at(next)] != 0 &&
                   (is_same(end_of(other, true), end_mm) || is_same(end_of(other, false), end_mm));
        });
    }

    void offer(int piece, double cost, int from, bool from_front) {
        cost += pieces_[at(piece)].length_mm * (1.0 - shares_[at(piece)]);
        if (cost >= ways_[at(piece)].cost) return;
        ways_[at(piece)] = {cost, from, from_front};
        waiting_.emplace(cost, piece);
    }

    void spread() {
        while (!waiting_.empty()) {
            const auto [cost, piece] = waiting_.top();
            waiting_.pop();
            Way& way = ways_[at(piece)];
            if (std::exchange(way.settled, true)) continue;
            const Vec3& far_mm = end_of(pieces_[at(piece)], !way.from_front);
            for (const int next : pieces_[at(piece)].neighbours) {
                if (chosen_[at(next)] != 0) continue;
                const bool front = is_same(end_of(pieces_[at(next)], true), far_mm);
                if (!front && !is_same(end_of(pieces_[at(next)], false), far_mm)) continue;
                Way& other = ways_[at(next)];
                // Two ways that meet head on are one, from a kept piece to another.
                const bool meets_a_way = other.settled && other.from_front != front;
                if (meets_a_way) other.leads_back = true;
                if (meets_a_way || meets_kept(next, !front))
                    way.leads_back = true;
                else
                    offer(next, cost, piece, front);
            }
        }
    }

    void append(int piece, Bridge& branch) const {
        const LinePiece& line = pieces_[at(piece)];
        const bool forward = ways_[at(piece)].from_front;
        const std::size_t count = line.points_mm.size();
        for (std::size_t k = branch.path_mm.empty() ? 0 : 1; k < count; ++k) {
            const std::size_t point = forward ? k : count - 1 - k;
            branch.path_mm.push_back(line.points_mm[point]);
            branch.radii_mm.push_back(line.radii_mm[point]);
        }
    }

    const std::vector<LinePiece>& pieces_;
    const std::vector<double>& shares_;
    const std::vector<std::uint8_t>& chosen_;
    std::vector<Way> ways_;
    std::vector<bool> taken_ = std::vector<bool>(pieces_.size());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

}  // namespace

std::vector<Bridge> offered_branches(const std::vector<LinePiece>& pieces,
                                     const std::vector<double>& shares,
                                     const std::vector<std::uint8_t>& chosen) {
    Ways ways(pieces, shares, chosen);
    std::vector<Bridge> branches;
    for (const int tip : ways.tips()) {
        const std::vector<int> chain = ways.take(tip);
        if (chain.empty()) continue;
        Bridge branch = ways.branch_along(chain);
        if (branch.gap_mm >= shortest_offer_mm && branch.confidence >= least_offered_share)
            branches.push_back(std::move(branch));
    }
    std::ranges::stable_sort(branches, std::ranges::greater{}, &Bridge::confidence);
    return branches;
}

}  // namespace hepatica
