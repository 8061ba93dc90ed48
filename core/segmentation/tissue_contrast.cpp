// SPDX-License-Identifier: GPL-3.0-or-later
// The local level of the parenchyma by normalised convolution on a coarse grid, repeated with
// outliers rejected.
#include "core/segmentation/tissue_contrast.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

constexpr double level_sigma_mm = 8.0;
constexpr double coarse_spacing_mm = 3.2;
constexpr double noise_smoothing_mm = 1.0;  // before voxels are classified as parenchyma
constexpr double outlier_deviations = 2.0;
constexpr double rim_mm = 3.0;
constexpr int rounds = 3;
// Weight of the liver's median against the voxels around: it decides where hardly any voxel counts.
constexpr float prior_weight = 0.02f;

// Robust statistics need only a sample: every n-th object voxel.
std::vector<float> sample(const FloatVolume& values, const Mask& where, const Job& job) {
    constexpr std::size_t enough = 400000;
    std::size_t objects = 0;
    for_each_voxel_in_order(where.voxels.size(), job,
                            [&](std::size_t i) { objects += where.voxels[i] != 0; });
    const std::size_t stride = std::max<std::size_t>(1, objects / enough);
    std::vector<float> chosen;
    chosen.reserve(objects / stride + 1);
    std::size_t seen = 0;
    for_each_voxel_in_order(where.voxels.size(), job, [&](std::size_t i) {
        if (where.voxels[i] && seen++ % stride == 0) chosen.push_back(values.voxels[i]);
    });
    return chosen;
}

// Sums over blocks of voxels: the convolution is wide, so a coarse grid is enough.
class CoarseLevel {
  public:
    explicit CoarseLevel(const Grid& fine)
        : block_(std::max(
              1, static_cast<int>(std::lround(coarse_spacing_mm / fine.spacing_mm.maxCoeff())))) {
        Grid coarse = fine;
        for (std::size_t a = 0; a < 3; ++a) {
            coarse.dims[a] = (fine.dims[a] + block_ - 1) / block_;
            coarse.spacing_mm[static_cast<Eigen::Index>(a)] *= block_;
        }
        coarse.origin_mm = fine.to_mm(Vec3::Constant(0.5 * (block_ - 1)));
        sum_ = FloatVolume(coarse);
        weight_ = FloatVolume(coarse);
    }

    // Local mean, around each coarse voxel, of the fine values for which count(i) holds;
    // `otherwise` where there are hardly any.
    template <class Count>
    FloatVolume mean(const FloatVolume& values, const Count& count, double otherwise, Job& job) {
        const Grid& fine = values.grid;
        parallel_blocks(
            static_cast<std::size_t>(sum_.grid.dims[2]), 1, [&](std::size_t begin, std::size_t) {
                job.throw_if_cancelled();
                const auto cz = static_cast<int>(begin);
                const std::size_t layer = sum_.grid.offset(0, 0, cz);
                const std::size_t size = sum_.grid.offset(0, 0, 1);
                std::fill_n(sum_.voxels.begin() + static_cast<std::ptrdiff_t>(layer), size, 0.0f);
                std::fill_n(weight_.voxels.begin() + static_cast<std::ptrdiff_t>(layer), size,
                            0.0f);
                for (int z = cz * block_; z < std::min(fine.dims[2], (cz + 1) * block_); ++z)
                    for (int y = 0; y < fine.dims[1]; ++y)
                        for (int x = 0; x < fine.dims[0]; ++x) {
                            const std::size_t i = fine.offset(x, y, z);
                            if (!count(i)) continue;
                            const std::size_t c = sum_.grid.offset(x / block_, y / block_, cz);
                            sum_.voxels[c] += values.voxels[i] - static_cast<float>(otherwise);
                            weight_.voxels[c] += 1.0f;
                        }
            });
        FloatVolume mean = sum_;
        FloatVolume weight = weight_;
        gaussian_smooth(mean, Vec3::Constant(level_sigma_mm), job);
        gaussian_smooth(weight, Vec3::Constant(level_sigma_mm), job);
        const float prior = prior_weight * static_cast<float>(block_ * block_ * block_);
        for (std::size_t i = 0; i < mean.voxels.size(); ++i)
            mean.voxels[i] = static_cast<float>(otherwise) +
                             mean.voxels[i] / (std::max(weight.voxels[i], 0.0f) + prior);
        return mean;
    }

  private:
    int block_;
    FloatVolume sum_;
    FloatVolume weight_;
};

void require_objects(const Mask& liver, const Mask& interior) {
    if (object_count(liver) == 0)
        throw InputError("the liver region is empty", "liver mask",
                         "Give a mask that lies inside the CT.");
    if (object_count(interior) == 0)
        throw InputError("the liver mask is so thin that nothing of it is further than 3 mm inside",
                         "liver mask", "Give a mask of the whole liver.");
}

}  // namespace

RobustSpread robust_spread(const FloatVolume& values, const Mask& where, const Job& job) {
    std::vector<float> chosen = sample(values, where, job);
    if (chosen.empty()) return {};
    RobustSpread spread;
    spread.median = median(chosen);
    std::vector<float> below;
    for (const float v : chosen)
        if (v <= static_cast<float>(spread.median))
            below.push_back(static_cast<float>(spread.median) - v);
    spread.deviation = 1.4826 * median(std::move(below));
    return spread;
}

TissueContrast measure_tissue(const FloatVolume& intensity, const Mask& liver, Job& job) {
    FloatVolume smooth = copied_image(intensity, job);
    in_part(job, 0.0, 0.1,
            [&] { gaussian_smooth(smooth, Vec3::Constant(noise_smoothing_mm), job); });
    TissueContrast tissue;
    tissue.interior = in_part(job, 0.1, 0.2, [&] { return erode(liver, rim_mm, job); });
    job.throw_if_cancelled();
    require_objects(liver, tissue.interior);
    RobustSpread spread = robust_spread(smooth, tissue.interior, job);
    job.throw_if_cancelled();
    tissue.parenchyma_hu = spread.median;
    CoarseLevel coarse(intensity.grid);
    FloatVolume level = filled_image(intensity.grid, static_cast<float>(spread.median), job);
    FloatVolume rise = filled_image(intensity.grid, 0.0f, job);
    const auto subtract = [&](const FloatVolume& from) {
        for_each_voxel(rise.voxels.size(), job, [&](std::size_t i) {
            rise.voxels[i] = liver.voxels[i] ? from.voxels[i] - level.voxels[i] : 0.0f;
        });
    };
    for (int round = 0; round < rounds; ++round) {
        const auto share = [](int done) { return 0.2 + 0.8 * done / rounds; };
        const JobPart part(job, share(round), share(round + 1));
        subtract(smooth);
        job.throw_if_cancelled();
        spread = robust_spread(rise, tissue.interior, job);
        job.throw_if_cancelled();
        const auto limit = static_cast<float>(outlier_deviations * spread.deviation);
        level = resample(
            coarse.mean(
                smooth,
                [&](std::size_t i) { return liver.voxels[i] && std::abs(rise.voxels[i]) < limit; },
                tissue.parenchyma_hu, job),
            intensity.grid, Interpolation::linear, job);
        job.advance(1.0);
    }
    subtract(intensity);
    job.throw_if_cancelled();
    spread = robust_spread(rise, tissue.interior, job);
    job.throw_if_cancelled();
    tissue.noise_hu = spread.deviation;
    tissue.excess = std::move(rise);
    for_each_voxel(liver.voxels.size(), job, [&](std::size_t i) {
        if (liver.voxels[i]) tissue.excess.voxels[i] -= static_cast<float>(spread.median);
    });
    return tissue;
}

}  // namespace hepatica
