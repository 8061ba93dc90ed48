// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian smoothing, one axis after the other, 32 lines at a time.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/filters.h"
#include "core/image/line_bundles.h"

namespace hepatica {

namespace {

// The recursion runs along the lines and is vectorised across them.
constexpr int lanes = line_lanes;

// Deriche, INRIA report 1893 (1993), order 4: for x >= 0 the Gaussian is approximated by the sum
// over k of (a_k cos(w_k x/s) + b_k sin(w_k x/s)) exp(-c_k x/s).
struct DericheTerm {
    double a, b, c, w;
};
constexpr std::array<DericheTerm, 2> deriche_terms{
    {{1.6800, 3.7350, 1.7830, 0.6318}, {-0.6803, -0.2598, 1.7230, 1.9970}}};
constexpr double smallest_recursive_sigma = 2.0;  // in voxels

// y[i] = sum n[k] x[i-k] - sum d[k] y[i-k], run from both ends; the two results are added.
struct Recursion {
    std::array<double, 4> forward{};   // of x[i], x[i-1], x[i-2], x[i-3]
    std::array<double, 4> backward{};  // of x[i+1] ... x[i+4]
    std::array<double, 4> feedback{};  // of y[i-1] ... y[i-4] (backward: y[i+1] ... y[i+4])
    double forward_gain = 0.0;         // response to a constant 1
    double backward_gain = 0.0;
};

Recursion deriche(double sigma) {
    // Each damped wave is (p + q/z) / (1 + r/z + s/z^2); both are brought to a common denominator.
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
        r.forward[k] = unit * n[k];
        r.feedback[k] = d[k + 1];
        r.backward[k] = unit * (n[k + 1] - d[k + 1] * n[0]);
    }
    r.forward_gain = unit * one_sided;
    r.backward_gain = unit * (one_sided - n[0]);
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

// One of the two filters, for the lines of one axis.
class LineSmoother {
  public:
    explicit LineSmoother(double sigma)
        : sigma_(sigma),
          recursive_(sigma >= smallest_recursive_sigma),
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
                const float weight = kernel_[k];
                for (int l = 0; l < lanes; ++l) sum[l] += weight * (a[l] + b[l]);
            }
            out[i] = sum;
        }
    }

    // In double precision where the poles are close to 1 and float would lose the constant part.
    void run_recursion(const std::vector<Lanes>& line, std::vector<Lanes>& out) const {
        if (sigma_ < 6.0)
            run_recursion<float>(line, out);
        else
            run_recursion<double>(line, out);
    }

    template <class Real>
    void run_recursion(const std::vector<Lanes>& line, std::vector<Lanes>& out) const {
        using Row = std::array<Real, lanes>;
        const int n = static_cast<int>(line.size());
        const std::array<Real, 4> forward = narrowed<Real>(recursion_.forward);
        const std::array<Real, 4> backward = narrowed<Real>(recursion_.backward);
        const std::array<Real, 4> feedback = narrowed<Real>(recursion_.feedback);
        std::array<Row, 4> x;  // ring buffers of the last four inputs and outputs
        std::array<Row, 4> y;
        const auto begin_with = [&](const Lanes& border, double gain) {
            for (int k = 0; k < 4; ++k)
                for (int l = 0; l < lanes; ++l) {
                    x[k][l] = static_cast<Real>(border[l]);
                    y[k][l] = static_cast<Real>(gain) * x[k][l];
                }
        };
        begin_with(line[0], recursion_.forward_gain);
        for (int i = 0; i < n; ++i) {
            Row& now = x[i & 3];
            Row& next = y[i & 3];
            for (int l = 0; l < lanes; ++l) {
                now[l] = static_cast<Real>(line[i][l]);
                next[l] = forward[0] * now[l] + forward[1] * x[(i - 1) & 3][l] +
                          forward[2] * x[(i - 2) & 3][l] + forward[3] * x[(i - 3) & 3][l] -
                          feedback[0] * y[(i - 1) & 3][l] - feedback[1] * y[(i - 2) & 3][l] -
                          feedback[2] * y[(i - 3) & 3][l] - feedback[3] * next[l];
                out[i][l] = static_cast<float>(next[l]);
            }
        }
        begin_with(line[n - 1], recursion_.backward_gain);
        for (int i = n - 1; i >= 0; --i) {
            Row& now = x[i & 3];
            Row& next = y[i & 3];
            for (int l = 0; l < lanes; ++l) {
                next[l] = backward[0] * x[(i + 1) & 3][l] + backward[1] * x[(i + 2) & 3][l] +
                          backward[2] * x[(i + 3) & 3][l] + backward[3] * now[l] -
                          feedback[0] * y[(i + 1) & 3][l] - feedback[1] * y[(i + 2) & 3][l] -
                          feedback[2] * y[(i + 3) & 3][l] - feedback[3] * next[l];
                out[i][l] += static_cast<float>(next[l]);
                now[l] = static_cast<Real>(line[i][l]);
            }
        }
    }

    template <class Real>
    static std::array<Real, 4> narrowed(const std::array<double, 4>& values) {
        return {static_cast<Real>(values[0]), static_cast<Real>(values[1]),
                static_cast<Real>(values[2]), static_cast<Real>(values[3])};
    }

    double sigma_;  // in voxels
    bool recursive_;
    Recursion recursion_;
    std::vector<float> kernel_;
};

}  // namespace

void gaussian_smooth(FloatVolume& image, const Vec3& sigma_mm, Job& job) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(sigma_mm[axis] >= 0.0) || !std::isfinite(sigma_mm[axis]))
            throw InputError("is " + number_text(sigma_mm[axis]), "smoothing width in mm",
                             "Choose a width of 0 or more");
        if (sigma_mm[axis] == 0.0 || image.grid.dims[axis] == 1) continue;
        const LineSmoother smoother(sigma_mm[axis] / image.grid.spacing_mm[axis]);
        filter_lines(image, axis, job, [&] {
            return [&smoother, spare = std::vector<Lanes>()](std::vector<Lanes>& line) mutable {
                smoother.smooth(line, spare);
            };
        });
    }
}

}  // namespace hepatica
