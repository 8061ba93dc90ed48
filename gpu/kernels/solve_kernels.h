// SPDX-License-Identifier: GPL-3.0-or-later
// Preconditioned conjugate gradients (Hestenes and Stiefel 1952) on the device, scalars included.
// Vectors are Real; sums, and the solution that corrections are added to, are double. The host
// learns of an iteration only later, from its record.
#pragma once

#include "gpu/kernels/product_kernels.h"

namespace hepatica::gpu {

// Record of one iteration, for the error bound.
struct IterationRecord {
    double step, ratio;             // alpha, beta
    double work, residual_squared;  // (r, z) and (r, r) after it
};

struct SolveScalars {
    double step, ratio, work, residual_squared;
    int iterations;  // since the last reset
    int broken;      // no positive curvature, or not finite: x stays as it is
};

// x = 0, r = b; sums r . r.
struct BeginSolve {
    static constexpr int width = 1;
    View<const Vector3<double>> b;
    View<Vector3<double>> x, r;

    std::size_t bytes() const { return bytes_of(b, x, r); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        x[i] = {{0.0, 0.0, 0.0}};
        r[i] = b[i];
        sum[0] += small::dot(b[i], b[i]);
    }
};

// x = 0, r = b, rounded, z = D^-1 r; sums r . z and r . r.
template <class Real>
struct BeginRound {
    static constexpr int width = 2;
    View<const Vector3<double>> b;
    MatrixPlanes<Real> inverse;
    View<Vector3<Real>> x, r, z;

    std::size_t bytes() const { return bytes_of(b, x, r, z) + bytes_of(inverse); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const Vector3<Real> residual = rounded<Real>(b[i]), image = inverse[i] * residual;
        x[i] = {{Real(0), Real(0), Real(0)}};
        r[i] = residual;
        z[i] = image;
        for (int c = 0; c < 3; ++c) {
            sum[0] += double(residual[c]) * double(image[c]);
            sum[1] += double(residual[c]) * double(residual[c]);
        }
    }
};

// Resets the scalars from r . z and r . r at the start.
struct StartIteration {
    static constexpr int width = 2;
    View<SolveScalars> scalars;
    HEPATICA_HOST_DEVICE void operator()(int, const double* sum) const {
        scalars[0] = {0.0, 0.0, sum[0], sum[1], 0, 0};
    }
};

// x += d
template <class Real>
struct AddCorrection {
    View<const Vector3<Real>> d;
    View<Vector3<double>> x;

    HEPATICA_HOST_DEVICE int count() const { return x.size; }
    std::size_t bytes() const { return bytes_of(d, x, x); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        for (int c = 0; c < 3; ++c) x[i][c] += double(d[i][c]);
    }
};

// p = z + beta p
template <class Real>
struct TurnDirection {
    View<const SolveScalars> scalars;
    View<const Vector3<Real>> z;
    View<Quad<Real>> p;

    HEPATICA_HOST_DEVICE int count() const { return p.size; }
    std::size_t bytes() const { return bytes_of(z, p, p); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        const Real ratio = Real(scalars[0].ratio);
        p[i] = quad_of(ratio == Real(0) ? z[i] : z[i] + ratio * vector_of(p[i]));
    }
};

// Computes alpha from p . A p.
struct ChooseStep {
    static constexpr int width = 1;
    View<SolveScalars> scalars;
    HEPATICA_HOST_DEVICE void operator()(int, const double* sum) const {
        SolveScalars& now = scalars[0];
        const double step = now.work / sum[0];
        if (!(sum[0] > 0.0) || !(step < 1e300)) now.broken = 1;
        now.step = now.broken != 0 ? 0.0 : step;
    }
};

// x += alpha p, r -= alpha A p, z = D^-1 r; sums r . z and r . r.
template <class Real>
struct TakeStep {
    static constexpr int width = 2;
    View<const SolveScalars> scalars;
    View<const Quad<Real>> p;
    View<const Vector3<Real>> product;
    MatrixPlanes<Real> inverse;
    View<Vector3<Real>> x, r, z;

    std::size_t bytes() const { return bytes_of(p, product, x, x, r, r, z) + bytes_of(inverse); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const Real step = Real(scalars[0].step);
        x[i] = x[i] + step * vector_of(p[i]);
        const Vector3<Real> residual = r[i] - step * product[i], image = inverse[i] * residual;
        r[i] = residual;
        z[i] = image;
        for (int c = 0; c < 3; ++c) {
            sum[0] += double(residual[c]) * double(image[c]);
            sum[1] += double(residual[c]) * double(residual[c]);
        }
    }
};

// Computes beta from r . z and r . r, and records the iteration.
struct EndIteration {
    static constexpr int width = 2;
    View<SolveScalars> scalars;
    View<IterationRecord> record;
    HEPATICA_HOST_DEVICE void operator()(int, const double* sum) const {
        SolveScalars& now = scalars[0];
        const double ratio = sum[0] / now.work;
        if (!(sum[0] >= 0.0) || !(ratio < 1e300)) now.broken = 1;
        if (now.broken == 0) {
            now.ratio = ratio;
            now.work = sum[0];
            now.residual_squared = sum[1];
            record[now.iterations++ % record.size] = {now.step, ratio, sum[0], sum[1]};
        }
    }
};

}  // namespace hepatica::gpu
