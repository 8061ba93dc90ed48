// SPDX-License-Identifier: GPL-3.0-or-later
// Scans of what is no liver, drawn from geometry and noise: what a person may open by mistake.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/image/volume.h"
#include "core/phantom/phantom_body.h"

namespace hepatica::test {

inline Volume scan_of(const Vec3& low, const Vec3& high, double spacing_mm, double noise_hu,
                      const std::function<double(const Vec3&)>& hu) {
    Grid grid;
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    grid.origin_mm = low;
    for (int a = 0; a < 3; ++a)
        grid.dims[a] = static_cast<int>((high[a] - low[a]) / spacing_mm) + 1;
    Volume ct(grid);
    std::mt19937 random(1);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        double noise = -6.0;  // of twelve uniform numbers: about normal, the same everywhere
        for (int k = 0; k < 12; ++k) noise += static_cast<double>(random()) / 4294967296.0;
        ct.voxels[i] =
            static_cast<std::int16_t>(std::lround(hu(grid.to_mm(x, y, z)) + noise_hu * noise));
    }
    return ct;
}

// A cylinder of water in a wall of acrylic, as scanners are calibrated with.
inline Volume water_phantom() {
    return scan_of(Vec3(-120, -120, -60), Vec3(120, 120, 60), 2.5, 10.0, [](const Vec3& p) {
        const double r = std::hypot(p.x(), p.y());
        return r < 100.0 ? 0.0 : r < 106.0 ? 120.0 : -1000.0;
    });
}

// Scalp, skull, brain with ventricles; with contrast medium, vessels along great circles in it.
inline Volume head(bool contrast) {
    const auto depth = [](const Vec3& p, double shrink) {
        const Vec3 radii = Vec3(78, 98, 88) - Vec3::Constant(shrink);
        return p.cwiseQuotient(radii).norm();
    };
    return scan_of(Vec3(-90, -110, -60), Vec3(90, 110, 100), 2.0, 6.0, [=](const Vec3& p) {
        if (depth(p, 0) > 1.0) return -1000.0;
        if (depth(p, 7) > 1.0) return 45.0;
        if (depth(p, 14) > 1.0) return 1000.0;
        if (contrast) {
            for (int k = 0; k < 6; ++k) {  // arteries and sinuses
                const double turn = k * 0.55;
                const double across = std::cos(turn) * p.x() + std::sin(turn) * p.y();
                const double within = p.norm() - (25.0 + 9.0 * k);
                if (across * across + within * within < 9.0) return 280.0;
            }
            if (std::hypot(p.x(), p.y() - 10.0) < 4.0 && p.z() < 20.0) return 300.0;
        }
        const Vec3 q = (p - Vec3(0, 5, 10)).cwiseQuotient(Vec3(14, 35, 12));
        if (q.norm() < 1.0) return 6.0;
        return contrast ? 42.0 : 36.0;
    });
}

// Lungs with vessels, heart and great vessels, chest wall; above the diaphragm.
inline Volume chest() {
    const PhantomBody body(1, 110.0);
    return scan_of(Vec3(-180, -130, 82), Vec3(180, 130, 220), 2.5, 10.0, [&](const Vec3& p) {
        const double hu = body.hu(p, 100.0, 2.5);
        if (hu > -700.0 || hu < -950.0) return hu;
        // In the lungs a tree of sheets stands in for vessels.
        const double s = std::sin(0.12 * p.x() + 0.05 * p.z()) + std::sin(0.11 * p.y()) +
                         std::sin(0.13 * p.z() + 0.06 * p.x());
        return std::abs(s) < 0.06 && std::sin(0.31 * p.z()) > 0.7 ? 40.0 : hu;
    });
}

}  // namespace hepatica::test
