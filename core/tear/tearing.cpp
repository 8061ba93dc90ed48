// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/tearing.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/tear/entropy.h"

namespace hepatica {
namespace {

constexpr std::size_t joint_block = 1024;
constexpr double not_yet = -1.0;  // entropy is never below 0
// Elastic energy per volume, relative to the strength, that rounding leaves in a body at rest:
// strains of some 1e-7.
constexpr double rounding_of_strength = 1e-14;
// Joints that share a vertex with an overloaded one part at this share of their own limit. Their
// ties bear the full strength, so that this weakens nothing.
constexpr double share_of_neighbour = Tearing::warning_load;

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "the checkpoint of a body",
                     "Make the stepper of the body that it was taken of");
}

// Normal of a triangle, or `otherwise` where it has no area.
Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& otherwise) {
    const Vec3 doubled = (b - a).cross(c - a);
    const double length = doubled.norm();
    return length > 0.0 ? Vec3(doubled / length) : otherwise;
}

bool inside(double share) {
    return share >= 0.0 && share <= 1.0;
}

}  // namespace

Tearing::Tearing(const TetMesh& mesh, const TearLaw& law, std::span<const double> strength_factor)
    : law_(law), softening_(law.softening()), topology_(mesh), whole_(mesh.tetrahedra) {
    validate(law);
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        volume_mm3_.push_back(signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                                mesh.vertices_mm[c], mesh.vertices_mm[d]));
    whole_volume_mm3_ = std::accumulate(volume_mm3_.begin(), volume_mm3_.end(), 0.0);
    for (const Joint& joint : topology_.joints()) {
        double factor = law.tear_factor;
        if (!strength_factor.empty())
            factor *=
                0.5 * (strength_factor[joint.tetrahedra[0]] + strength_factor[joint.tetrahedra[1]]);
        factor_.push_back(factor);
        sides_.push_back(joint.tetrahedra);
    }
    weakness_.assign(factor_.size(), 1.0);
    most_mm_.assign(factor_.size(), {0.0, 0.0, 0.0});
    count();
}

void Tearing::weaken(std::span<const int> joints, double factor) {
    if (!(factor >= 0.0) || !std::isfinite(factor))
        throw InputError("is " + number_text(factor), "strength along a cut line",
                         "Give 0 (nothing holds) to 1 (as the tissue around)");
    const int count = static_cast<int>(weakness_.size());
    if (!std::ranges::all_of(joints, [&](int j) { return j >= 0 && j < count; }))
        throw InputError("names a joint that does not exist", "cut line",
                         "The body has joints 0 to " + std::to_string(count - 1));
    for (const int j : joints)
        if (!topology_.parted(j)) weakness_[j] *= factor;
    any_weakened_ = any_weakened_ || !joints.empty();
}

std::vector<int> Tearing::weakened() const {
    std::vector<int> joints;
    if (!any_weakened_) return joints;  // as in most steps of most scenes
    for (int j = 0; j < static_cast<int>(weakness_.size()); ++j)
        if (weakness_[j] != 1.0 && !topology_.parted(j)) joints.push_back(j);
    return joints;
}

std::vector<int> Tearing::crossing(const Vec3& corner_mm, const Vec3& first_edge_mm,
                                   const Vec3& second_edge_mm,
                                   std::span<const Vec3> positions_mm) const {
    const Vec3 normal = first_edge_mm.cross(second_edge_mm);
    std::vector<int> found;
    if (!(normal.squaredNorm() > 0.0)) return found;
    const auto centre = [&](int t) {
        const auto& [a, b, c, d] = topology_.tetrahedra()[t];
        return Vec3(0.25 * (positions_mm[a] + positions_mm[b] + positions_mm[c] + positions_mm[d]));
    };
    const auto joints = topology_.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (!holds(static_cast<int>(j))) continue;
        const Vec3 from = centre(joints[j].tetrahedra[0]) - corner_mm;
        const Vec3 to = centre(joints[j].tetrahedra[1]) - corner_mm;
        const double before = from.dot(normal), after = to.dot(normal);
        if ((before >= 0.0) == (after >= 0.0)) continue;
        const Vec3 at = from + before / (before - after) * (to - from);
        const double scale = normal.squaredNorm();
        if (inside(at.cross(second_edge_mm).dot(normal) / scale) &&
            inside(first_edge_mm.cross(at).dot(normal) / scale))
            found.push_back(static_cast<int>(j));
    }
    return found;
}

double Tearing::load_of(const Joint& joint, double limit_pa, const TearLoads& loads) const {
    const Vec3 traction = traction_on(joint, loads.stress_pa[joint.tetrahedra[0]],
                                      loads.stress_pa[joint.tetrahedra[1]]);
    const auto& one = topology_.tetrahedra()[joint.tetrahedra[0]];
    const auto corner = [&](int k) -> const Vec3& {
        return loads.positions_mm[one[joint.corners[0][k]]];
    };
    const double pull =
        effective_traction_pa(traction, normal_of(corner(0), corner(1), corner(2), joint.normal));
    if (limit_pa > 0.0) return pull / limit_pa;
    return pull > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

// No traction exceeds the mean of the two stresses' norms, so most joints are skipped cheaply.
void Tearing::find_loads(const TearLoads& loads, double least, std::vector<double>& load) {
    stress_pa_.resize(loads.stress_pa.size());
    parallel_blocks(stress_pa_.size(), joint_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) stress_pa_[t] = loads.stress_pa[t].norm();
    });
    const auto joints = topology_.joints();
    load.assign(joints.size(), 0.0);
    parallel_blocks(joints.size(), joint_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            const double limit = law_.strength_pa * factor_[j] * weakness_[j];
            const auto& [one, other] = sides_[j];
            if (0.5 * (stress_pa_[one] + stress_pa_[other]) < least * limit) continue;
            if (topology_.parted(static_cast<int>(j)) || !std::isfinite(limit)) continue;
            load[j] = load_of(joints[j], limit, loads);
        }
    });
}

// How many of these joints, from the first on, may part within the budget of vertices. Only near
// its end does it cost copies of the topology.
std::size_t Tearing::within_budget(std::span<const int> joints) const {
    const auto fits = [&](std::size_t count) {
        TornTopology parted = topology_;
        parted.part(joints.first(count), volume_mm3_);
        return parted.vertex_count() - topology_.vertex_count() + report_.vertices_split <=
               law_.vertex_budget;
    };
    constexpr std::size_t corners = 3;  // of a joint: the most vertices that it splits off
    const auto left =
        static_cast<std::size_t>(std::max(0, law_.vertex_budget - report_.vertices_split));
    if (corners * joints.size() <= left) return joints.size();
    std::size_t low = 0, high = joints.size() + 1;  // low fits, high does not
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

bool Tearing::part_overloaded(const TearLoads& loads) {
    warns_ = false;
    if (stopped_) {
        load_.clear();
        return false;
    }
    find_loads(loads, warning_load, load_);
    std::vector<int> parting;
    for (std::size_t j = 0; j < load_.size(); ++j) {
        if (!(load_[j] >= warning_load)) continue;
        warns_ = true;
        if (load_[j] >= 1.0) parting.push_back(static_cast<int>(j));
    }
    // The most loaded first, equal ones by position, so that the numbering does not decide what
    // tears.
    const auto rank = [&](int j) {
        const Vec3& at = topology_.joints()[j].centre_mm;
        return std::tuple(-load_[j], at.x(), at.y(), at.z());
    };
    std::ranges::sort(parting, {}, rank);
    if (parting.size() > most_joints) parting.resize(most_joints);
    if (!law_.bare_limit) add_neighbours(parting);
    if (parting.empty()) return false;
    if (law_.stop == TearStop::vertices) {
        std::ranges::sort(parting, {}, rank);
        parting.resize(within_budget(parting));
        std::ranges::sort(parting);
    }
    if (parting.empty()) {
        stopped_ = report_.stopped = true;
        return false;
    }
    part(parting, law_.bare_limit ? softening_.opening_mm : softening_.peak_mm());
    return true;
}

// Adds joints next to those that part or have begun to soften. A vertex opens only when all joints
// in the crack's way there have parted; without their neighbours a crack would advance in jumps.
void Tearing::add_neighbours(std::vector<int>& parting) const {
    std::vector<int> all = parting, sources = parting;
    for (std::size_t i = 0; i < ties_.size(); ++i)
        if (ties_[i].most_mm > softening_.peak_mm() && !apart(ties_[i].most_mm) &&
            (sources.empty() || sources.back() != tied_[i].joint))
            sources.push_back(tied_[i].joint);
    for (const int j : sources)
        for (int k = 0; k < 3; ++k)
            for (const int v : topology_.sides(topology_.joints()[j], k))
                for (const int other : topology_.joints_at(v))
                    if (load_[other] >= share_of_neighbour) all.push_back(other);
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    parting = std::move(all);
}

void Tearing::cut(std::span<const int> joints) {
    std::vector<int> whole;
    for (const int j : joints)
        if (topology_.parted(j))
            most_mm_[j].fill(softening_.opening_mm);
        else
            whole.push_back(j);
    part(whole, softening_.opening_mm);
}

bool Tearing::holds(int joint) const {
    return !topology_.parted(joint) ||
           !std::ranges::all_of(most_mm_[joint], [this](double most) { return apart(most); });
}

void Tearing::part(std::span<const int> joints, double most_mm) {
    const int before = topology_.vertex_count();
    topology_.part(joints, volume_mm3_);
    // What bears nothing is bound by nothing.
    for (const int j : joints)
        most_mm_[j].fill(factor_[j] * weakness_[j] > 0.0 ? most_mm : softening_.opening_mm);
    if (!load_.empty())
        for (const int j : joints) load_[j] = 0.0;
    parted_.insert(parted_.end(), joints.begin(), joints.end());
    std::ranges::sort(parted_);
    if (!begun_ && topology_.vertex_count() > before) {
        begun_ = true;
        entropy_before_ = elastic_ > 0.0 ? entropy_ : not_yet;
    }
    make_ties();
    count();
}

void Tearing::make_ties() {
    ties_.clear();
    tied_.clear();
    for (const int j : parted_) {
        const Joint& joint = topology_.joints()[j];
        for (int k = 0; k < 3; ++k) {
            const auto sides = topology_.sides(joint, k);
            const double area = joint.area_mm2 / 3.0 * factor_[j] * weakness_[j];
            if (sides[0] == sides[1] || apart(most_mm_[j][k]) || !(area > 0.0)) continue;
            SofteningTie tie{.vertices = sides, .area_mm2 = area, .most_mm = most_mm_[j][k]};
            for (int i = 0; i < 3; ++i) tie.triangle[i] = topology_.sides(joint, i)[0];
            tie.normal = joint.normal;
            ties_.push_back(tie);
            tied_.push_back({j, k});
        }
    }
}

void Tearing::take_openings(std::span<const SofteningTie> ties) {
    bool broke = false;
    for (std::size_t i = 0; i < ties.size(); ++i) {
        broke = broke || (apart(ties[i].most_mm) && !apart(ties_[i].most_mm));
        ties_[i].most_mm = ties[i].most_mm;
        most_mm_[tied_[i].joint][tied_[i].corner] = ties[i].most_mm;
    }
    if (broke) count();
}

std::vector<std::array<int, 2>> Tearing::parted_pairs() const {
    std::vector<std::array<int, 2>> pairs;
    for (const int j : parted_)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = topology_.sides(topology_.joints()[j], k);
            if (a != b) pairs.push_back({std::min(a, b), std::max(a, b)});
        }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

void Tearing::measure(const TearLoads& loads) {
    weights_.assign(topology_.vertex_count(), 0.0);
    double elastic = 0.0;
    for (std::size_t t = 0; t < loads.energy_nj.size(); ++t) {
        const double share = 0.25 * std::max(0.0, loads.energy_nj[t]);
        elastic += share;
        for (const int v : topology_.tetrahedra()[t]) weights_[v] += share;
    }
    // A body at rest stores what rounding leaves, whose distribution says nothing.
    if (elastic <= rounding_of_strength * law_.strength_pa * whole_volume_mm3_) elastic = 0.0;
    entropy_ = entropy_nats(elastic > 0.0 ? std::span<const double>(weights_) : loads.mass_g);
    elastic_ = elastic;
    // For a body that was cut at rest, the first strained state is the reference.
    if (begun_ && entropy_before_ == not_yet && elastic > 0.0) entropy_before_ = entropy_;
    report_entropy();
    if (!begun_) return;
    if (law_.stop == TearStop::entropy)
        stopped_ = stopped_ || report_.entropy_produced_nats > law_.entropy_budget_nats;
    else if (law_.stop == TearStop::vertices)
        stopped_ = stopped_ || report_.vertices_split >= law_.vertex_budget;
    report_.stopped = stopped_;
}

std::vector<std::array<int, 2>> Tearing::bound_pairs() const {
    std::vector<std::array<int, 2>> bound;
    for (const SofteningTie& tie : ties_)
        if (!apart(tie.most_mm)) bound.push_back(tie.vertices);
    return bound;
}

std::vector<OpenJoint> Tearing::open_joints() const {
    const auto ascending = [](std::array<int, 2> pair) {
        return std::array{std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
    };
    // Ties of other joints may bind the same vertices.
    std::vector<std::array<int, 2>> bound = bound_pairs();
    for (std::array<int, 2>& pair : bound) pair = ascending(pair);
    std::ranges::sort(bound);
    std::vector<OpenJoint> open;
    for (const int j : parted_) {
        OpenJoint one{.joint = j};
        for (int k = 0; k < 3; ++k) {
            const auto sides = topology_.sides(topology_.joints()[j], k);
            one.corners[k] =
                sides[0] != sides[1] && !std::ranges::binary_search(bound, ascending(sides));
        }
        if (one.corners != std::array<bool, 3>{}) open.push_back(one);
    }
    return open;
}

void Tearing::report_entropy() {
    const bool known = begun_ && entropy_before_ != not_yet;
    report_.entropy_nats = entropy_;
    report_.entropy_produced_nats = known ? std::max(0.0, entropy_ - entropy_before_) : 0.0;
}

// Everything that only a change of topology or ties changes.
void Tearing::count() {
    TearReport& report = report_;
    report.joints_parted = static_cast<int>(parted_.size());
    report.joints_broken = report.vertices_split = 0;
    report.torn_area_mm2 = 0.0;
    for (const int j : parted_) {
        const Joint& joint = topology_.joints()[j];
        int free = 0;
        for (int k = 0; k < 3; ++k) {
            const auto sides = topology_.sides(joint, k);
            free += sides[0] != sides[1] && apart(most_mm_[j][k]) ? 1 : 0;
        }
        report.joints_broken += free == 3 ? 1 : 0;
        report.torn_area_mm2 += joint.area_mm2 * free / 3.0;
    }
    for (int v = 0; v < topology_.vertex_count(); ++v)
        report.vertices_split += topology_.parents()[v] != v ? 1 : 0;
    report.pieces = topology_.pieces(bound_pairs());
    if (whole_pieces_ == 0) whole_pieces_ = report.pieces;  // called first on the whole body
    report.pieces_off = report.pieces - whole_pieces_;
}

TearState Tearing::state() const {
    TearState state;
    const auto parents = topology_.parents();
    for (int v = 0; v < topology_.vertex_count(); ++v)
        if (parents[v] != v) state.parents.push_back(parents[v]);
    for (std::size_t t = 0; t < whole_.size(); ++t) {
        const auto& corners = topology_.tetrahedra()[t];
        if (corners == whole_[t]) continue;
        state.tetrahedra.push_back(static_cast<int>(t));
        state.corners.insert(state.corners.end(), corners.begin(), corners.end());
    }
    state.parted = parted_;
    for (const int j : parted_)
        state.most_mm.insert(state.most_mm.end(), most_mm_[j].begin(), most_mm_[j].end());
    for (std::size_t j = 0; j < weakness_.size(); ++j)
        if (weakness_[j] != 1.0) {
            state.weakened.push_back(static_cast<int>(j));
            state.weakness.push_back(weakness_[j]);
        }
    state.begun = begun_;
    state.stopped = stopped_;
    state.entropy_before_nats = entropy_before_;
    state.entropy_nats = entropy_;
    return state;
}

void Tearing::restore(const TearState& state) {
    const int joints = static_cast<int>(weakness_.size());
    const auto ascending = [](const std::vector<int>& values, int count) {
        return std::ranges::adjacent_find(values, std::ranges::greater_equal{}) == values.end() &&
               std::ranges::all_of(values, [&](int v) { return v >= 0 && v < count; });
    };
    if (state.corners.size() != 4 * state.tetrahedra.size() ||
        state.most_mm.size() != 3 * state.parted.size() ||
        state.weakness.size() != state.weakened.size() ||
        !ascending(state.tetrahedra, static_cast<int>(whole_.size())) ||
        !ascending(state.parted, joints) || !ascending(state.weakened, joints) ||
        !std::ranges::all_of(state.most_mm, [](double most) { return most >= 0.0; }) ||
        !std::ranges::all_of(state.weakness, [](double factor) { return factor >= 0.0; }))
        refuse("is torn otherwise than this body can be");
    const std::size_t vertices = topology_.vertex_count() - report_.vertices_split;
    std::vector<int> parents;
    for (std::size_t v = 0; v < vertices; ++v) parents.push_back(static_cast<int>(v));
    parents.insert(parents.end(), state.parents.begin(), state.parents.end());
    std::vector<std::array<int, 4>> tetrahedra = whole_;
    for (std::size_t i = 0; i < state.tetrahedra.size(); ++i)
        std::copy_n(state.corners.begin() + 4 * i, 4, tetrahedra[state.tetrahedra[i]].begin());
    topology_.restore(state.parted, parents, tetrahedra);
    parted_ = state.parted;
    for (auto& most : most_mm_) most.fill(0.0);
    for (std::size_t i = 0; i < parted_.size(); ++i)
        std::copy_n(state.most_mm.begin() + 3 * i, 3, most_mm_[parted_[i]].begin());
    weakness_.assign(weakness_.size(), 1.0);
    for (std::size_t i = 0; i < state.weakened.size(); ++i)
        weakness_[state.weakened[i]] = state.weakness[i];
    begun_ = state.begun;
    // What another law has stopped goes on under one that never stops.
    stopped_ = state.stopped && law_.stop != TearStop::none;
    entropy_before_ = state.entropy_before_nats;
    entropy_ = state.entropy_nats;
    any_weakened_ = !state.weakened.empty();
    load_.clear();
    warns_ = false;
    make_ties();
    count();
    report_entropy();
    report_.stopped = stopped_;
}

}  // namespace hepatica
