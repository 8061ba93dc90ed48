// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"

namespace hepatica {

namespace {

// Lines are filtered side by side, so that the recursion along them vectorises across them.
constexpr int lanes = 32;
using Lanes = std::array<float, lanes>;

// Deriche, INRIA report 1893 (1993), order 4: for x >= 0 the Gaussian is near
// sum over k of (a_k cos(w_k x/s) + b_k sin(w_k x/s)) exp(-c_k x/s).
struct DericheTerm {
    double a, b, c, w;
};
constexpr std::array<DericheTerm, 2> deriche_terms{
    {{1.6800, 3.7350, 1.7830, 0.6318}, {-0.6803, -0.2598, 1.7230, 1.9970}}};
constexpr double smallest_recursive_sigma = 2.0;  // in voxels

// y[i] = sum n[k] x[i-k] - sum d[k] y[i-k], run from both ends and added.
struct Recursion {
    std::array<float, 4> forward{};   // of x[i], x[i-1], x[i-2], x[i-3]
    std::array<float, 4> backward{};  // of x[i+1] ... x[i+4]
    std::array<float, 4> feedback{};  // of y[i-1] ... y[i-4] (y[i+1] ... y[i+4])
    float forward_gain = 0.0f;        // answer to a constant 1
    float backward_gain = 0.0f;
};

Recursion deriche(double sigma) {
    // Each damped wave is (p + q/z) / (1 + r/z + s/z^2); the two are brought to one denominator.
    std::array<std::array<double, 2>, 2> numerator{};
    std::array<std::array<double, 3>, 2> denominator{};
    for (int k = 0; k < 2; ++k) {
        const DericheTerm& t = deriche_terms[k];
        const double decay = std::exp(-t.c / sigma);
        const double angle = t.w / sigma;
        numerator[k] = {t.a, decay * (t.b * std::sin(angle) - t.a * std::cos(angle))};
        denominator[k] = {1.0, -2.0 * decay * std::cos(angle), decay * decay};
    }
    std::array<double, 5> n{};
    std::array<double, 5> d{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 2; ++j)
            n[i + j] += denominator[1][i] * numerator[0][j] + denominator[0][i] * numerator[1][j];
        for (int j = 0; j < 3; ++j) d[i + j] += denominator[0][i] * denominator[1][j];
    }
    const double one_sided =
        std::accumulate(n.begin(), n.end(), 0.0) / std::accumulate(d.begin(), d.end(), 0.0);
    const double unit = 1.0 / (2.0 * one_sided - n[0]);  // the two halves share x = 0
    Recursion r;
    for (int k = 0; k < 4; ++k) {
        r.forward[k] = static_cast<float>(unit * n[k]);
        r.feedback[k] = static_cast<float>(d[k + 1]);
        r.backward[k] = static_cast<float>(unit * (n[k + 1] - d[k + 1] * n[0]));
    }
    r.forward_gain = static_cast<float>(unit * one_sided);
    r.backward_gain = static_cast<float>(unit * (one_sided - n[0]));
    return r;
}

std::vector<float> sampled_kernel(double sigma) {
    const int radius = static_cast<int>(std::ceil(4.0 * sigma));
    std::vector<double> half(static_cast<std::size_t>(radius) + 1);
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        half[i] = std::exp(-0.5 * i * i / (sigma * sigma));
        sum += (i == 0 ? 1.0 : 2.0) * half[i];
    }
    std::vector<float> kernel;
    for (const double weight : half) kernel.push_back(static_cast<float>(weight / sum));
    return kernel;
}

// One of both filters, for lines of one axis.
class LineSmoother {
  public:
    explicit LineSmoother(double sigma)
        : recursive_(sigma >= smallest_recursive_sigma),
          recursion_(recursive_ ? deriche(sigma) : Recursion{}),
          kernel_(recursive_ ? std::vector<float>{} : sampled_kernel(sigma)) {}

    // Smooths `line` (n samples, lanes side by side) in place; `spare` is scratch memory.
    void smooth(std::vector<Lanes>& line, std::vector<Lanes>& spare) const {
        spare.resize(line.size());
        if (recursive_)
            run_recursion(line, spare);
        else
            convolve(line, spare);
        line.swap(spare);
    }

  private:
    void convolve(const std::vector<Lanes>& line, std::vector<Lanes>& out) const {
        const int n = static_cast<int>(line.size());
        for (int i = 0; i < n; ++i) {
            Lanes sum;
            for (int l = 0; l < lanes; ++l) sum[l] = kernel_[0] * line[i][l];
            for (int k = 1; k < static_cast<int>(kernel_.size()); ++k) {
                const Lanes& a = line[std::max(i - k, 0)];
                const Lanes& b = line[std::min(i + k, n - 1)];
                for (int l = 0; l < lanes; ++l) sum[l] += kernel_[k] * (a[l] + b[l]);
            }
            out[i] = sum;
        }
    }

    void run_recursion(const std::vector<Lanes>& line, std::vector<Lanes>& out) const {
        const int n = static_cast<int>(line.size());
        const Recursion& r = recursion_;
        std::array<Lanes, 4> x;  // ring buffers of the last four inputs and outputs
        std::array<Lanes, 4> y;
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < lanes; ++l) {
                x[k][l] = line[0][l];
                y[k][l] = r.forward_gain * line[0][l];
            }
        for (int i = 0; i < n; ++i) {
            x[i & 3] = line[i];
            Lanes& next = y[i & 3];
            for (int l = 0; l < lanes; ++l)
                next[l] = r.forward[0] * x[i & 3][l] + r.forward[1] * x[(i - 1) & 3][l] +
                          r.forward[2] * x[(i - 2) & 3][l] + r.forward[3] * x[(i - 3) & 3][l] -
                          r.feedback[0] * y[(i - 1) & 3][l] - r.feedback[1] * y[(i - 2) & 3][l] -
                          r.feedback[2] * y[(i - 3) & 3][l] - r.feedback[3] * next[l];
            out[i] = next;
        }
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < lanes; ++l) {
                x[k][l] = line[n - 1][l];
                y[k][l] = r.backward_gain * line[n - 1][l];
            }
        for (int i = n - 1; i >= 0; --i) {
            Lanes& next = y[i & 3];
            for (int l = 0; l < lanes; ++l) {
                next[l] = r.backward[0] * x[(i + 1) & 3][l] + r.backward[1] * x[(i + 2) & 3][l] +
                          r.backward[2] * x[(i + 3) & 3][l] + r.backward[3] * x[i & 3][l] -
                          r.feedback[0] * y[(i + 1) & 3][l] - r.feedback[1] * y[(i + 2) & 3][l] -
                          r.feedback[2] * y[(i + 3) & 3][l] - r.feedback[3] * next[l];
                out[i][l] += next[l];
            }
            x[i & 3] = line[i];
        }
    }

    bool recursive_;
    Recursion recursion_;
    std::vector<float> kernel_;
};

// The lines along `axis`, in bundles of `lanes` neighbours along the axis that runs across them.
class Bundles {
  public:
    Bundles(FloatVolume& image, int axis) : image_(image), axis_(axis) {
        const Grid& grid = image.grid;
        across_ = axis == 0 ? 1 : 0;
        rest_ = axis == 2 ? 1 : 2;
        per_row_ = (grid.dims[across_] + lanes - 1) / lanes;
        strides_ = {1, static_cast<std::size_t>(grid.dims[0]), grid.offset(0, 0, 1)};
    }

    std::size_t count() const {
        return static_cast<std::size_t>(per_row_) * image_.grid.dims[rest_];
    }

    void load(std::size_t bundle, std::vector<Lanes>& line) const {
        line.resize(image_.grid.dims[axis_]);
        visit(bundle, line, [](float& voxel, float& sample) { sample = voxel; });
    }
    void store(std::size_t bundle, std::vector<Lanes>& line) const {
        visit(bundle, line, [](float& voxel, float& sample) { voxel = sample; });
    }

  private:
    template <class Move>
    void visit(std::size_t bundle, std::vector<Lanes>& line, const Move& move) const {
        const int first = static_cast<int>(bundle % per_row_) * lanes;
        const int width = std::min(lanes, image_.grid.dims[across_] - first);
        float* start =
            image_.voxels.data() + first * strides_[across_] + bundle / per_row_ * strides_[rest_];
        if (axis_ == 0) {  // along memory: one lane after the other
            for (int l = 0; l < width; ++l)
                for (std::size_t i = 0; i < line.size(); ++i)
                    move(start[l * strides_[1] + i], line[i][l]);
        } else {
            for (std::size_t i = 0; i < line.size(); ++i)
                for (int l = 0; l < width; ++l) move(start[i * strides_[axis_] + l], line[i][l]);
        }
    }

    FloatVolume& image_;
    int axis_;
    int across_;
    int rest_;
    int per_row_;
    std::array<std::size_t, 3> strides_;
};

void smooth_axis(FloatVolume& image, int axis, double sigma_voxels, Job& job) {
    const Bundles bundles(image, axis);
    const LineSmoother smoother(sigma_voxels);
    std::atomic<std::size_t> done{0};
    constexpr std::size_t block = 16;
    parallel_blocks(bundles.count(), block, [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> line;
        std::vector<Lanes> spare;
        for (std::size_t b = begin; b < end; ++b) {
            bundles.load(b, line);
            smoother.smooth(line, spare);
            bundles.store(b, line);
        }
        done += end - begin;
        job.advance((axis + static_cast<double>(done) / static_cast<double>(bundles.count())) /
                    3.0);
    });
}

}  // namespace

void gaussian_smooth(FloatVolume& image, const Vec3& sigma_mm, Job& job) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(sigma_mm[axis] >= 0.0) || !std::isfinite(sigma_mm[axis]))
            throw InputError("is " + std::to_string(sigma_mm[axis]), "smoothing width in mm",
                             "Choose a width of 0 or more");
        if (sigma_mm[axis] > 0.0 && image.grid.dims[axis] > 1)
            smooth_axis(image, axis, sigma_mm[axis] / image.grid.spacing_mm[axis], job);
    }
}

}  // namespace hepatica
