// SPDX-License-Identifier: GPL-3.0-or-later
// Implements judge_systems() on evenly spaced samples of the centrelines.
#include "core/accuracy/system_scores.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/accuracy/mask_on_grid.h"
#include "core/accuracy/surface_dice.h"
#include "core/base/disjoint_sets.h"

namespace hepatica {

namespace {

constexpr double anywhere = std::numeric_limits<double>::max();

// The segments of one system, without nodes; their node and parent indices are not valid.
VesselTree only(const VesselTree& tree, VascularSystem system) {
    VesselTree part;
    for (const VesselSegment& segment : tree.segments)
        if (segment.system == system) part.segments.push_back(segment);
    return part;
}

void set_lengths(SystemScore& score, const FoundLengths& of_truth, const FoundLengths& of_tree) {
    score.truth_length_mm = sum(of_truth).all_mm;
    score.tree_length_mm = sum(of_tree).all_mm;
    score.length_recall = sum(of_truth).share();
    score.length_precision = sum(of_tree).share();
    for (std::size_t i = 0; i < score.by_radius.size(); ++i) {
        RadiusClass& size = score.by_radius[i];
        size.from_mm = i == 0 ? 0.0 : radius_class_borders_mm[i - 1];
        size.to_mm = i < radius_class_borders_mm.size() ? radius_class_borders_mm[i]
                                                        : std::numeric_limits<double>::infinity();
        size.truth_length_mm = of_truth[i].all_mm;
        size.tree_length_mm = of_tree[i].all_mm;
        if (of_truth[i].all_mm > 0.0) size.length_recall = of_truth[i].share();
        if (of_tree[i].all_mm > 0.0) size.length_precision = of_tree[i].share();
    }
}

// Root of the longest connected piece whose root carries the system.
std::optional<Vec3> main_root(const VesselTree& tree, VascularSystem system) {
    std::vector<double> hanging_mm(tree.segments.size(), 0.0);
    int longest = -1;
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        const VesselSegment& segment = tree.segments[i];
        hanging_mm[i] += length_mm(segment);
        if (segment.parent >= 0)
            hanging_mm[segment.parent] += hanging_mm[i];
        else if (segment.system == system && (longest < 0 || hanging_mm[i] > hanging_mm[longest]))
            longest = static_cast<int>(i);
    }
    if (longest < 0) return std::nullopt;
    return tree.segments[longest].points_mm.front();
}

// Scores one tree against the known systems; the tree is sampled once.
class Judge {
  public:
    Judge(const VesselTree& tree, const Mask& mask, const KnownSystems& known,
          const SystemScoreOptions& options, Job& job)
        : tree_(tree),
          mask_(mask),
          known_(known),
          options_(options),
          job_(job),
          line_(sampled(tree, known.step_mm(), &known.judged())) {
        for (const CentrelineSample& sample : line_.samples)
            truth_of_.push_back(
                sample.judged ? known.system_at(sample.position_mm, options.length_tolerance_mm)
                              : std::uint8_t{0});
    }

    SystemScore score_of(const KnownSystem& known) const {
        SystemScore score;
        score.system = known.system;
        const CentrelineLocator ours(only(tree_, known.system));
        set_lengths(score, found(known.samples, every, {&ours}),
                    found(line_,
                          [&](const CentrelineSample& sample) {
                              return tree_.segments[sample.segment].system == known.system;
                          },
                          {&known.locator}));
        judge_voxels(score, known.lumen, [&](std::uint8_t label) {
            return label == static_cast<std::uint8_t>(known.system);
        });
        judge_root(score, known);
        return score;
    }

    SystemScore score_of_all() const {
        SystemScore score;
        const CentrelineLocator ours(tree_);
        FoundLengths of_truth;
        std::vector<const CentrelineLocator*> theirs;
        Mask lumen(known_.judged().grid);
        for (const KnownSystem& known : known_.all()) {
            theirs.push_back(&known.locator);
            const FoundLengths more = found(known.samples, every, {&ours});
            for (std::size_t i = 0; i < more.size(); ++i) {
                of_truth[i].found_mm += more[i].found_mm;
                of_truth[i].all_mm += more[i].all_mm;
            }
            for (std::size_t i = 0; i < lumen.voxels.size(); ++i)
                lumen.voxels[i] |= known.lumen.voxels[i];
        }
        set_lengths(score, of_truth, found(line_, every, theirs));
        judge_voxels(score, lumen, [](std::uint8_t label) { return label != 0; });
        return score;
    }

    FoundLength labels() const {
        FoundLength right;
        for (std::size_t i = 0; i < truth_of_.size(); ++i)
            if (truth_of_[i] != 0)
                right.add(line_.samples[i].weight_mm, carried(i) == truth_of_[i]);
        return right;
    }

    int false_joins() const { return count_false_joins(line_, truth_of_, options_.joins); }

    // Number of pieces of the tree along each connected piece of the judged truth beyond the first.
    int breaks_of(const KnownSystem& known) const {
        const auto system = static_cast<std::uint8_t>(known.system);
        const std::vector<CentrelineSample>& truth = known.samples.samples;
        if (truth.empty()) return 0;  // a mask without a line, such as a ball, has no pieces
        DisjointSets ours(line_.samples.size()), theirs(truth.size());
        for (const CentrelineStep& step : line_.steps)
            if (carried(step.from) == system && carried(step.to) == system)
                ours.unite(step.from, step.to);
        for (const CentrelineStep& step : known.samples.steps)
            if (truth[step.from].judged && truth[step.to].judged) theirs.unite(step.from, step.to);
        std::map<std::uint32_t, std::map<std::uint32_t, double>> along_mm;  // theirs, ours
        for (std::size_t i = 0; i < truth_of_.size(); ++i) {
            if (truth_of_[i] != system || carried(i) != system) continue;
            const auto at = known.locator.nearest(line_.samples[i].position_mm, anywhere);
            const int there = known.samples.nearest(at->segment, at->position_mm);
            if (truth[there].judged)
                along_mm[theirs.root(there)][ours.root(static_cast<std::uint32_t>(i))] +=
                    line_.samples[i].weight_mm;
        }
        int breaks = 0;
        for (const auto& [piece, lengths] : along_mm) {
            int pieces = 0;
            for (const auto& [ours_there, mm] : lengths) pieces += mm >= options_.joins.stray_mm;
            breaks += std::max(0, pieces - 1);
        }
        return breaks;
    }

  private:
    static bool every(const CentrelineSample&) { return true; }

    FoundLengths found(const CentrelineSamples& line,
                       const std::function<bool(const CentrelineSample&)>& wanted,
                       const std::vector<const CentrelineLocator*>& others) const {
        return found_lengths(line, wanted, others, options_.length_tolerance_mm);
    }

    std::uint8_t carried(std::size_t sample) const {
        return static_cast<std::uint8_t>(tree_.segments[line_.samples[sample].segment].system);
    }

    void judge_root(SystemScore& score, const KnownSystem& known) const {
        const std::vector<Vec3> ends = known_.trunk_ends(known);
        if (!ends.empty()) score.trunk_at_mm = ends.front();
        const std::optional<Vec3> root = main_root(tree_, known.system);
        if (!root || ends.empty()) return;
        score.trunk_at_mm = *std::ranges::min_element(
            ends, {}, [&](const Vec3& end) { return (end - *root).norm(); });
        score.root_error_mm = (*score.trunk_at_mm - *root).norm();
    }

    template <class Wanted>
    void judge_voxels(SystemScore& score, const Mask& lumen, const Wanted& wanted) const {
        if (mask_.voxels.empty()) return;
        Mask ours(mask_.grid);
        std::ranges::transform(mask_.voxels, ours.voxels.begin(), [&](std::uint8_t label) {
            return static_cast<std::uint8_t>(wanted(label));
        });
        ours = mask_on_grid(ours, lumen.grid, job_);
        const Mask& judged = known_.judged();
        double both = 0.0, all = 0.0;
        for (std::size_t i = 0; i < ours.voxels.size(); ++i) {
            if (judged.voxels[i] == 0) continue;
            both += ours.voxels[i] && lumen.voxels[i];
            all += ours.voxels[i] + lumen.voxels[i];
        }
        score.dice = all > 0.0 ? 2.0 * both / all : 1.0;
        score.surface_dice = surface_dice(ours, lumen, judged, options_.surface_tolerance_mm, job_);
    }

    const VesselTree& tree_;
    const Mask& mask_;
    const KnownSystems& known_;
    const SystemScoreOptions& options_;
    Job& job_;
    CentrelineSamples line_;              // of the tree
    std::vector<std::uint8_t> truth_of_;  // the true system of each sample; 0: none
};

}  // namespace

SystemScores judge_systems(const VesselTree& tree, const Mask& mask, const KnownSystems& known,
                           const SystemScoreOptions& options, Job& job) {
    const Judge judge(tree, mask, known, options, job);
    SystemScores scores;
    const auto count = static_cast<double>(known.all().size());
    for (const KnownSystem& system : known.all()) {
        scores.systems.push_back(judge.score_of(system));
        scores.breaks += judge.breaks_of(system);
        job.advance(0.5 + 0.4 * static_cast<double>(scores.systems.size()) / count);
    }
    scores.vessels = judge.score_of_all();
    const FoundLength labels = judge.labels();
    scores.system_right = labels.share();
    scores.attributed_mm = labels.all_mm;
    scores.false_joins = judge.false_joins();
    for (const VesselSegment& segment : tree.segments) scores.loops += segment.closes_loop;
    job.advance(1.0);
    return scores;
}

SystemScores judge_systems(const VesselTree& tree, const Mask& mask,
                           std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                           const SystemScoreOptions& options, Job& job) {
    const KnownSystems known(truths, liver, cava, options.cava, job);
    job.advance(0.5);
    return judge_systems(tree, mask, known, options, job);
}

}  // namespace hepatica
