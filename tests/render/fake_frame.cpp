// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/fake_frame.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/deform/body/obstacles.h"

namespace hepatica::testing {
namespace {

constexpr int around = 24;

struct Builder {
    std::vector<std::array<int, 3>> triangles;
    std::vector<float> positions_mm;
    std::vector<float> arrival_s;

    void ring(const Vec3& centre, const Vec3& u, const Vec3& v, double radius, double arrival) {
        for (int i = 0; i < around; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / around;
            const Vec3 point = centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
            for (int c = 0; c < 3; ++c) positions_mm.push_back(static_cast<float>(point[c]));
            arrival_s.push_back(static_cast<float>(arrival));
        }
    }

    void tube(const Vec3& from, const Vec3& to, double radius, double arrival, int generation) {
        const Vec3 axis = (to - from).normalized();
        const Vec3 u = axis.unitOrthogonal();
        const Vec3 v = axis.cross(u);
        const int rings = 14;
        const int first = static_cast<int>(arrival_s.size());
        const double duration = (to - from).norm() / 40.0;
        for (int r = 0; r <= rings; ++r) {
            const double s = static_cast<double>(r) / rings;
            ring(from + s * (to - from), u, v, radius * (1.0 - 0.2 * s), arrival + s * duration);
        }
        for (int r = 0; r < rings; ++r) {
            for (int i = 0; i < around; ++i) {
                const int a = first + r * around + i;
                const int b = first + r * around + (i + 1) % around;
                triangles.push_back({a, b, b + around});
                triangles.push_back({a, b + around, a + around});
            }
        }
        if (generation == 0) return;
        const Vec3 side = generation % 2 == 0 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        for (const double turn : {-0.6, 0.55}) {
            const Vec3 direction = (axis + turn * (side + 0.6 * Vec3(1, 0, 0))).normalized();
            tube(to - 0.5 * radius * axis, to + 0.75 * (to - from).norm() * direction,
                 0.74 * radius, arrival + duration, generation - 1);
        }
    }
};

}  // namespace

Frame fake_frame(double bend, double drug_time_s) {
    Builder builder;
    builder.tube(Vec3(0, 0, -60), Vec3(0, 0, -15), 6.0, 0.0, 4);
    for (std::size_t v = 0; v < builder.positions_mm.size(); v += 3) {
        const double height = builder.positions_mm[v + 2] + 60.0;
        builder.positions_mm[v] += static_cast<float>(bend * 0.002 * height * height);
    }
    Frame frame;
    frame.topology_version = 1;
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(builder.triangles);
    frame.positions_mm = std::move(builder.positions_mm);
    if (drug_time_s >= 0.0) {
        frame.drug.arrival_s =
            std::make_shared<const std::vector<float>>(std::move(builder.arrival_s));
        frame.drug.version = 1;
        frame.drug.time_s = drug_time_s;
        frame.drug.end_s = 3.2;
    }
    return frame;
}

Frame touched_frame() {
    Frame frame = fake_frame(0.1);
    ToolView tool;
    tool.parts = {{Vec3(34, -24, -52), Vec3(6, -9, -34), 2.5}};
    tool.centre_mm = Vec3(20, -16.5, -43);
    tool.tip_mm = Vec3(6, -9, -34);
    tool.at_mm = Vec3(3.5, -9, -34);
    tool.force_un = Vec3(16e3, -4e3, 5e3);
    for (std::size_t v = 0; 3 * v < frame.positions_mm.size(); ++v) {
        const float* x = &frame.positions_mm[3 * v];
        if ((Vec3(x[0], x[1], x[2]) - tool.tip_mm).norm() < 9.0)
            tool.touched.push_back(static_cast<int>(v));
    }
    frame.tool = tool;
    return frame;
}

Frame frame_beside_obstacles() {
    Frame frame = fake_frame(0.3);
    const auto obstacle = [](const Vec3& centre_mm, double radius_mm, SurfaceKind kind) {
        return Obstacle{sphere(centre_mm, radius_mm), kind};
    };
    frame.obstacles = std::make_shared<const Obstacles>(
        Obstacles{{obstacle(Vec3(14, 0, -22), 9.0, SurfaceKind::solid),
                   obstacle(Vec3(0, 0, 0), 62.0, SurfaceKind::shell)}});
    return frame;
}

TriangleMesh sphere(const Vec3& centre_mm, double radius_mm) {
    constexpr int meridians = 48;
    constexpr int bands = 24;
    TriangleMesh mesh;
    const auto at = [&](int band, int meridian) {
        if (band == 0) return 0;
        if (band == bands) return 1;
        return 2 + (band - 1) * meridians + meridian % meridians;
    };
    mesh.vertices_mm = {centre_mm + radius_mm * Vec3::UnitZ(),
                        centre_mm - radius_mm * Vec3::UnitZ()};
    for (int band = 1; band < bands; ++band) {
        const double polar = std::numbers::pi * band / bands;
        for (int m = 0; m < meridians; ++m) {
            const double turn = 2.0 * std::numbers::pi * m / meridians;
            mesh.vertices_mm.push_back(
                centre_mm + radius_mm * Vec3(std::sin(polar) * std::cos(turn),
                                             std::sin(polar) * std::sin(turn), std::cos(polar)));
        }
    }
    for (int band = 0; band < bands; ++band) {
        for (int m = 0; m < meridians; ++m) {
            if (band + 1 < bands) {
                mesh.triangles.push_back({at(band, m), at(band + 1, m), at(band + 1, m + 1)});
            }
            if (band > 0) {
                mesh.triangles.push_back({at(band, m), at(band + 1, m + 1), at(band, m + 1)});
            }
        }
    }
    return mesh;
}

}  // namespace hepatica::testing
