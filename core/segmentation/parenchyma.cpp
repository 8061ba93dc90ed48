// SPDX-License-Identifier: GPL-3.0-or-later
// Alternates between a local mean of the parenchyma (normalised convolution with a Gaussian) and
// the voxels that resemble it, until the region hardly grows.
#include "core/segmentation/parenchyma.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

constexpr double seat_depth_share = 0.5;
constexpr double field_mm = 10.0;  // sigma of the Gaussian of the local mean
constexpr double least_support = 0.03;
constexpr double widest_field_hu = 35.0;  // from the seat's mean
// Neighbours that are brighter than the liver (heart, spleen, cava) are more often as smooth as it
// than darker ones are.
constexpr double spreads_above = 2.4;
constexpr double spreads_below = 2.7;
// Texture and vessels widen the measured spread, a very even liver narrows it; neither may decide
// alone.
constexpr double least_spread_hu = 7.0;
constexpr double most_spread_hu = 9.0;
constexpr double neck_mm = 7.0;  // radius; parenchyma does not grow through anything narrower
constexpr int most_rounds = 12;
constexpr double still_growing = 1.003;
constexpr std::size_t tissue_block = 8192;

double mean_in(const FloatVolume& hu, const Mask& mask) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (mask.voxels[i] != 0) {
            sum += static_cast<double>(hu.voxels[i]);
            ++count;
        }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

// Local mean and share of the parenchyma's voxels; `far_hu` where none is near.
void measure_field(const FloatVolume& smooth, double far_hu, Parenchyma& grown, Job& job) {
    constexpr float far_support = 1e-3f;
    grown.hu = FloatVolume(smooth.grid);
    grown.support = FloatVolume(smooth.grid);
    const auto base = static_cast<float>(far_hu);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i)
        if (grown.voxels.voxels[i] != 0) {
            grown.hu.voxels[i] = smooth.voxels[i] - base;
            grown.support.voxels[i] = 1.0f;
        }
    gaussian_smooth(grown.hu, Vec3::Constant(field_mm), job);
    gaussian_smooth(grown.support, Vec3::Constant(field_mm), job);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
        const float support = grown.support.voxels[i];
        grown.hu.voxels[i] = base + (support > far_support ? grown.hu.voxels[i] / support : 0.0f);
    }
}

// 1.4826 times the median absolute deviation from the local mean (the standard deviation of normal
// noise), clamped.
double spread_of(const FloatVolume& smooth, const Parenchyma& grown) {
    std::vector<float> deviations;
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i)
        if (grown.voxels.voxels[i] != 0)
            deviations.push_back(std::abs(smooth.voxels[i] - grown.hu.voxels[i]));
    if (deviations.empty()) return least_spread_hu;
    return std::clamp(1.4826 * static_cast<double>(median(std::move(deviations))), least_spread_hu,
                      most_spread_hu);
}

Mask like_parenchyma(const FloatVolume& smooth, const Parenchyma& grown, double seat_hu) {
    Mask alike(smooth.grid);
    const double most = spreads_above * grown.spread_hu, least = -spreads_below * grown.spread_hu;
    parallel_blocks(alike.voxels.size(), tissue_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto near_hu = static_cast<double>(grown.hu.voxels[i]);
            const double above_hu = static_cast<double>(smooth.voxels[i]) - near_hu;
            alike.voxels[i] = static_cast<double>(grown.support.voxels[i]) > least_support &&
                              std::abs(near_hu - seat_hu) < widest_field_hu && above_hu < most &&
                              above_hu > least;
        }
    });
    return alike;
}

// Of the voxels of `alike`, the piece wider than a neck that holds most of the seat; empty where
// there is none.
Mask without_necks(const Mask& alike, const Mask& seat, Job& job) {
    const Mask core = erode(alike, neck_mm, job);
    job.throw_if_cancelled();
    const Components pieces = connected_components(core, Connectivity::faces6, job);
    std::vector<std::size_t> of_seat(pieces.sizes.size() + 1, 0);
    for (std::size_t i = 0; i < seat.voxels.size(); ++i)
        if (seat.voxels[i] != 0) ++of_seat[pieces.labels.voxels[i]];
    of_seat[0] = 0;
    const auto best = static_cast<std::uint32_t>(std::max_element(of_seat.begin(), of_seat.end()) -
                                                 of_seat.begin());
    Mask piece(alike.grid);
    if (best == 0) return piece;
    for (std::size_t i = 0; i < piece.voxels.size(); ++i)
        piece.voxels[i] = pieces.labels.voxels[i] == best;
    piece = dilate(piece, neck_mm + 0.01, job);
    for (std::size_t i = 0; i < piece.voxels.size(); ++i)
        if (alike.voxels[i] == 0) piece.voxels[i] = 0;
    return piece;
}

}  // namespace

Mask seat_of(const Mask& core, Job& job) {
    const FloatVolume depth = distance_to(complement(core), job);
    std::size_t deepest = 0;
    for (std::size_t i = 0; i < depth.voxels.size(); ++i)
        if (depth.voxels[i] > depth.voxels[deepest]) deepest = i;
    const double most_mm = static_cast<double>(depth.voxels[deepest]);
    if (!std::isfinite(most_mm)) return core;
    Mask deep(core.grid);
    for (std::size_t i = 0; i < deep.voxels.size(); ++i)
        deep.voxels[i] = static_cast<double>(depth.voxels[i]) >= seat_depth_share * most_mm;
    const Components pieces = connected_components(deep, Connectivity::faces6, job);
    for (std::size_t i = 0; i < deep.voxels.size(); ++i)
        deep.voxels[i] = pieces.labels.voxels[i] == pieces.labels.voxels[deepest];
    Mask seat = dilate(deep, seat_depth_share * most_mm, job);
    for (std::size_t i = 0; i < seat.voxels.size(); ++i)
        if (core.voxels[i] == 0) seat.voxels[i] = 0;
    return seat;
}

Parenchyma grow_parenchyma(const FloatVolume& smooth, const Mask& seat, Job& job) {
    Parenchyma grown;
    grown.voxels = seat;
    const double seat_hu = mean_in(smooth, seat);
    std::size_t before = 0;
    for (int round = 0; round < most_rounds; ++round) {
        const JobPart part(job, static_cast<double>(round) / most_rounds,
                           static_cast<double>(round + 1) / most_rounds);
        measure_field(smooth, seat_hu, grown, job);
        grown.spread_hu = spread_of(smooth, grown);
        Mask next = without_necks(like_parenchyma(smooth, grown, seat_hu), seat, job);
        const std::size_t size = object_count(next);
        if (size == 0) break;  // nothing is wider than a neck: the result of the round before stays
        grown.voxels = std::move(next);
        if (static_cast<double>(size) <= still_growing * static_cast<double>(before)) break;
        before = size;
    }
    return grown;
}

}  // namespace hepatica
