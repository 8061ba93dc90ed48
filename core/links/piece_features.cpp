// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the features in the order of piece_feature_names: brightness, lines, ring, shape,
// neighbours, depth, image.
#include "core/links/piece_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/parallel.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"
#include "core/links/way_to_sure.h"
#include "core/segmentation/line_coherence.h"

namespace hepatica {

namespace {

constexpr std::array half_lengths_mm{2.0, 3.5, 6.0};
constexpr int ring_points = 12;
constexpr double ring_gap_mm = 1.5;  // from the wall to the ring
constexpr double low_quantile = 0.2;
constexpr double deepest_mm = 40.0;

// The quantile of a sorted list, by the nearest rank.
double at_share(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

float nearest(const FloatVolume& image, const Vec3& p) {
    const auto [x, y, z] = nearest_voxel(image.grid, p);
    return image.at(x, y, z);
}

Vec3 direction_at(const LinePiece& piece, std::size_t i) {
    constexpr std::size_t reach = 3;
    const std::size_t from = i > reach ? i - reach : 0;
    const std::size_t to = std::min(piece.points_mm.size() - 1, i + reach);
    const Vec3 along = piece.points_mm[to] - piece.points_mm[from];
    return along.squaredNorm() > 0.0 ? Vec3(along.normalized()) : Vec3(Vec3::UnitX());
}

// Intensities on a ring around the axis, ascending.
std::array<double, ring_points> ring_around(const FloatVolume& rise, const Vec3& centre,
                                            const Vec3& axis, double radius_mm) {
    int least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Vec3 u = axis.cross(Vec3::Unit(least)).normalized();
    const Vec3 v = axis.cross(u);
    std::array<double, ring_points> ring;
    for (int k = 0; k < ring_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / ring_points;
        ring[k] = nearest(rise, centre + radius_mm * (std::cos(angle) * u + std::sin(angle) * v));
    }
    std::ranges::sort(ring);
    return ring;
}

// Line coherence on the voxels of the pieces, one image for each half length.
std::array<FloatVolume, half_lengths_mm.size()> lines_through(const std::vector<LinePiece>& pieces,
                                                              const FloatVolume& rise, Job& job) {
    Mask axis(rise.grid);
    for (const LinePiece& piece : pieces)
        for (const Vec3& p : piece.points_mm)
            if (const auto at = voxel_at(axis.grid, p)) axis.at((*at)[0], (*at)[1], (*at)[2]) = 1;
    std::array<FloatVolume, half_lengths_mm.size()> lines;
    for (std::size_t k = 0; k < lines.size(); ++k)
        lines[k] = line_coherence(rise, axis, {.half_length_mm = half_lengths_mm[k]}, job);
    return lines;
}

class Measuring {
  public:
    Measuring(const std::vector<LinePiece>& pieces, const PieceImage& image, Job& job)
        : image_(image),
          lines_(lines_through(pieces, image.evidence.rise, job)),
          depth_(distance_to(complement(image.liver), job)) {}

    // The features of brightness, line and ring, in the order of the names.
    std::vector<double> own(const LinePiece& piece) const {
        const double deviation = image_.evidence.deviation_hu;
        std::vector<double> rise, line;
        std::array<double, 3> lines{};
        std::array<double, 5> ring{};
        for (std::size_t i = 0; i < piece.points_mm.size(); ++i) {
            const Vec3& p = piece.points_mm[i];
            rise.push_back(nearest(image_.evidence.rise, p) / deviation);
            line.push_back(nearest(lines_[1], p) / image_.evidence.false_line_hu);
            for (std::size_t k = 0; k < lines.size(); ++k)
                lines[k] += nearest(lines_[k], p) / image_.evidence.false_line_hu;
            const auto around = ring_around(image_.evidence.rise, p, direction_at(piece, i),
                                            piece.radii_mm[i] + ring_gap_mm);
            const std::array<double, 4> levels{around[8], around[5], around[2], around[11]};
            for (std::size_t k = 0; k < levels.size(); ++k)
                ring[k] += rise.back() - levels[k] / deviation;
            ring[4] += around[1] / deviation;
        }
        const auto count = static_cast<double>(piece.points_mm.size());
        const double mean = mean_of(rise);
        std::ranges::sort(rise);
        std::ranges::sort(line);
        std::vector<double> values{mean, at_share(rise, low_quantile),
                                   mean * deviation / image_.vessel_rise_hu};
        for (const double sum : lines) values.push_back(sum / count);
        values.push_back(at_share(line, low_quantile));
        for (const double sum : ring) values.push_back(sum / count);
        return values;
    }

    std::array<double, 2> depths(const LinePiece& piece) const {
        double sum = 0.0, least = deepest_mm;
        for (const Vec3& p : piece.points_mm) {
            const double depth = std::min<double>(nearest(depth_, p), deepest_mm);
            sum += depth;
            least = std::min(least, depth);
        }
        return {sum / static_cast<double>(piece.points_mm.size()), least};
    }

  private:
    const PieceImage& image_;
    std::array<FloatVolume, half_lengths_mm.size()> lines_;
    FloatVolume depth_;
};

double mean_radius(const LinePiece& piece) {
    return mean_of(piece.radii_mm);
}

void append_shape(const LinePiece& piece, std::vector<double>& values) {
    const double radius = mean_radius(piece);
    const auto [least, most] = std::ranges::minmax(piece.radii_mm);
    const double chord = (piece.points_mm.back() - piece.points_mm.front()).norm();
    values.insert(values.end(),
                  {radius, (most - least) / radius, piece.length_mm, piece.link_length_mm,
                   piece.length_mm > 0.0 ? chord / piece.length_mm : 1.0,
                   static_cast<double>(piece.free_ends)});
}

// Cosine of the turn from one piece into another where their nearest ends meet: 1 is straight on.
double alignment(const LinePiece& a, const LinePiece& b) {
    double nearest_mm = std::numeric_limits<double>::infinity(), straightness = -1.0;
    for (const bool a_front : {true, false})
        for (const bool b_front : {true, false}) {
            const Vec3& p = a_front ? a.points_mm.front() : a.points_mm.back();
            const Vec3& q = b_front ? b.points_mm.front() : b.points_mm.back();
            if ((p - q).norm() >= nearest_mm) continue;
            nearest_mm = (p - q).norm();
            const Vec3 into = p - (a_front ? a.points_mm.back() : a.points_mm.front());
            const Vec3 out = (b_front ? b.points_mm.back() : b.points_mm.front()) - q;
            const double norms = into.norm() * out.norm();
            straightness = norms > 0.0 ? into.dot(out) / norms : 0.0;
        }
    return straightness;
}

// The features of components and neighbours, in the order of the names. `values` holds the features
// that come before them.
std::vector<std::array<double, 8>> company_of(const std::vector<LinePiece>& pieces,
                                              const std::vector<std::vector<double>>& values,
                                              const std::vector<double>& radii) {
    std::vector<double> strengths;
    for (const std::vector<double>& own : values) strengths.push_back(own[4]);
    const std::vector<int> component = components_of(pieces);
    std::vector<double> length(pieces.size()), widest(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        length[component[i]] += pieces[i].length_mm;
        widest[component[i]] = std::max(widest[component[i]], radii[i]);
    }
    const std::vector<WayToSure> ways = ways_to_sure(pieces, strengths, radii);
    std::vector<std::array<double, 8>> company;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        double wide = 0.0, bright = 0.0, straight = -1.0;
        for (const int next : pieces[i].neighbours) {
            wide = std::max(wide, radii[next]);
            bright = std::max(bright, values[next][0]);
            straight = std::max(straight, alignment(pieces[i], pieces[next]));
        }
        company.push_back({length[component[i]], widest[component[i]],
                           static_cast<double>(pieces[i].neighbours.size()), wide / radii[i],
                           bright / std::max(values[i][0], 0.1), straight, ways[i].distance_mm,
                           ways[i].weakest_line});
    }
    return company;
}

std::array<double, 5> of_the_image(const PieceImage& image, double radius_mm) {
    const double voxel_mm = std::cbrt(image.ct_spacing_mm.prod());
    return {image.vessel_rise_hu / image.evidence.deviation_hu,
            image.evidence.false_line_hu / image.evidence.deviation_hu,
            image.ct_spacing_mm.maxCoeff(), voxel_mm, radius_mm / voxel_mm};
}

}  // namespace

std::vector<PieceFeatures> piece_features(const std::vector<LinePiece>& pieces,
                                          const PieceImage& image, Job& job) {
    if (pieces.empty()) return {};
    const Measuring measuring(pieces, image, job);
    std::vector<std::vector<double>> values(pieces.size());
    parallel_blocks(pieces.size(), 16, [&](std::size_t begin, std::size_t end) {
        job.throw_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) {
            values[i] = measuring.own(pieces[i]);
            append_shape(pieces[i], values[i]);
        }
    });
    std::vector<double> radii;
    for (const LinePiece& piece : pieces) radii.push_back(mean_radius(piece));
    const auto company = company_of(pieces, values, radii);
    std::vector<PieceFeatures> features(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto append = [&](const auto& more) {
            values[i].insert(values[i].end(), more.begin(), more.end());
        };
        append(company[i]);
        append(measuring.depths(pieces[i]));
        append(of_the_image(image, radii[i]));
        std::ranges::transform(values[i], features[i].begin(),
                               [](double v) { return static_cast<float>(v); });
    }
    return features;
}

}  // namespace hepatica
