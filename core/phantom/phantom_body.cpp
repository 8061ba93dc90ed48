// SPDX-License-Identifier: GPL-3.0-or-later
// Builds organs from ellipsoids and elliptic columns, joined by smooth minima, and paints them one
// over the other.
#include "core/phantom/phantom_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/phantom/phantom_random.h"

namespace hepatica {

namespace {

// Approximate signed distance to an ellipsoid (Quilez): 0 on it, with the right sign everywhere.
double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    const Vec3 q = (p - centre).cwiseQuotient(radii);
    const double k0 = q.norm();
    const double k1 = q.cwiseQuotient(radii).norm();
    return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
}

// The same near the organ; farther away the distance to its box, which is cheaper.
double organ(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    constexpr double far_mm = 5.0;
    const double outside = ((p - centre).cwiseAbs() - radii).maxCoeff();
    return outside > far_mm ? outside : ellipsoid(p, centre, radii);
}

// An elliptic column along z.
double column(const Vec3& p, double x, double y, double radius_x, double radius_y) {
    const double dx = (p[0] - x) / radius_x;
    const double dy = (p[1] - y) / radius_y;
    const double k0 = std::sqrt(dx * dx + dy * dy);
    const double k1 = std::sqrt(dx * dx / (radius_x * radius_x) + dy * dy / (radius_y * radius_y));
    return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -std::min(radius_x, radius_y);
}

double smooth_union(double a, double b, double width) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * h * h * width;
}

double smooth_difference(double a, double b, double width) {
    return -smooth_union(-a, b, width);
}

// Paints tissue over what was painted before, with a soft border.
class Brush {
  public:
    explicit Brush(double softness_mm) : scale_(1.0 / softness_mm) {}

    void paint(double distance_mm, double tissue_hu) {
        const double share = std::clamp(0.5 - distance_mm * scale_, 0.0, 1.0);
        hu_ += share * (tissue_hu - hu_);
    }
    double hu() const { return hu_; }

  private:
    double scale_;
    double hu_ = -1000.0;
};

constexpr double push_step_mm = 0.5;
constexpr double push_reach_mm = 200.0;
constexpr int push_count = 801;

constexpr double fat_hu = -100.0;
constexpr double muscle_hu = 58.0;
constexpr double lung_hu = -860.0;

double torso_distance(const Vec3& p) {
    return column(p, 0, 2, 165, 116);
}

void paint_spine(Brush& brush, const Vec3& p) {
    brush.paint(column(p, -34, 84, 26, 17), muscle_hu);
    brush.paint(column(p, 34, 84, 26, 17), muscle_hu);
    const double body = column(p, 0, 60, 22, 17);
    const double in_unit = p[2] / 34.0 - std::floor(p[2] / 34.0);  // one vertebra and its disc
    const double disc = 4.5 - 34.0 * std::abs(in_unit - 0.5);
    brush.paint(body, 480.0);
    brush.paint(body + 2.5, 190.0);
    brush.paint(std::max(body, -disc), 80.0);
    brush.paint(column(p, 0, 84, 14, 12), 450.0);
    brush.paint(column(p, 0, 84, 9, 8), 25.0);
    brush.paint(column(p, 0, 103, 3.5, 11), 400.0);
}

// Ribs: slanting rings in the wall, open at the front.
void paint_ribs(Brush& brush, const Vec3& p, double torso) {
    const double slanted = (p[2] + 0.45 * p[1]) / 27.0;
    const double along_z = 27.0 * std::abs(slanted - std::round(slanted)) - 5.0;
    const double across = std::abs(torso + 25.0) - 4.0;
    const double rib = std::max({along_z, across, -60.0 - p[1], -p[2] - 60.0});
    brush.paint(rib, 420.0);
    brush.paint(rib + 2.0, 200.0);
}

void paint_wall(Brush& brush, const Vec3& p, double torso) {
    brush.paint(torso, 30.0);  // skin
    brush.paint(torso + 2.5, fat_hu);
    brush.paint(torso + 17.0, muscle_hu);
    brush.paint(torso + 32.0, fat_hu);
    if (torso > -34.0) paint_ribs(brush, p, torso);
}

// The lungs rest on the domes of the diaphragm, and on the liver where that rises higher.
void paint_chest(Brush& brush, const Vec3& p, double torso, double liver) {
    const double from_dome = std::abs(p[0]) - 68.0;
    const double base = 58.0 - (from_dome * from_dome + p[1] * p[1]) / 150.0 - p[2];
    brush.paint(std::max({base - 4.0, torso + 32.0}), muscle_hu);
    brush.paint(std::max({base, torso + 34.0, 4.0 - liver}), lung_hu);
    brush.paint(organ(p, {20, -36, 92}, {56, 46, 44}), 130.0);  // heart
}

void paint_organs(Brush& brush, const Vec3& p) {
    brush.paint(organ(p, {92, 36, 12}, {34, 46, 50}), 122.0);  // spleen
    const double stomach = organ(p, {48, -18, 0}, {36, 40, 44});
    brush.paint(stomach, 55.0);
    brush.paint(stomach + 3.0, 12.0);
    brush.paint(std::max(stomach + 3.0, p[1] + 38.0), -900.0);
    for (const double side : {-1.0, 1.0}) {
        const double kidney = organ(p, {side * 62, 58, -70}, {26, 24, 50});
        brush.paint(kidney, 185.0);
        brush.paint(organ(p, {side * 52, 54, -70}, {13, 10, 26}), fat_hu);
    }
    brush.paint(column(p, 12, 34, 10.5, 10.5), 155.0);          // aorta
    brush.paint(column(p, -22, 40, 11.5, 10.0), 132.0);         // inferior vena cava
    brush.paint(organ(p, {-48, -24, -62}, {14, 19, 24}), 8.0);  // gallbladder
}

}  // namespace

PhantomBody::PhantomBody(std::uint64_t seed, double parenchyma_hu) : parenchyma_hu_(parenchyma_hu) {
    PhantomRandom random(scrambled(seed));
    for (std::vector<Vec3>& push : push_) {
        push.assign(push_count, Vec3::Zero());
        for (int i = 0; i < 3; ++i) {
            const double wave_length_mm = random.uniform(55.0, 95.0);
            const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
            for (int k = 0; k < push_count; ++k)
                push[k][i] =
                    1.4 *
                    std::sin(2.0 * std::numbers::pi * (k * push_step_mm) / wave_length_mm + phase);
        }
    }
    for (int i = 0; i < 34; ++i) {
        Loop loop;
        loop.centre = random.point({-110, -75, -110}, {110, 30, -35});
        loop.radii = random.point({10, 9, 12}, {20, 16, 24});
        loop.content_hu = random.uniform() < 0.4 ? -800.0 : random.uniform(5.0, 40.0);
        bowel_.push_back(loop);
    }
}

Vec3 PhantomBody::wobble(const Vec3& p) const {
    Vec3 moved = p;
    for (int j = 0; j < 3; ++j) {
        const double at =
            std::clamp((p[j] + push_reach_mm) / push_step_mm, 0.0, push_count - 1.001);
        const int k = static_cast<int>(at);
        moved += (k + 1 - at) * push_[j][k] + (at - k) * push_[j][k + 1];
    }
    return moved;
}

double PhantomBody::liver_distance_mm(const Vec3& p) const {
    const Vec3 middle = 0.5 * (liver_low() + liver_high());
    const Vec3 half = 0.5 * (liver_high() - liver_low());
    const double outside = ((p - middle).cwiseAbs() - half).maxCoeff();
    if (outside > 12.0) return outside;  // far away the distance to the box suffices

    const Vec3 q = wobble(p);
    const double right_lobe = ellipsoid(q, {-67, 8, -4}, {60, 71, 73});
    const double left_lobe = ellipsoid(q, {-12, -37, 22}, {74, 36, 38});
    double liver = smooth_union(right_lobe, left_lobe, 30.0);
    const double visceral = ellipsoid(q, {18, 36, -54}, {70, 62, 64});
    liver = smooth_difference(liver, visceral, 22.0);
    liver = smooth_difference(liver, column(q, 2, 62, 40, 34), 14.0);
    liver = smooth_difference(liver, ellipsoid(q, {-48, -24, -62}, {16, 21, 26}), 6.0);
    return std::max(liver, torso_distance(p) + 34.0);
}

double PhantomBody::hu(const Vec3& p, double liver_distance_mm, double softness_mm) const {
    Brush brush(softness_mm);
    const double torso = torso_distance(p);
    if (torso > softness_mm) return brush.hu();
    paint_wall(brush, p, torso);
    if (torso < -30.0) {
        for (const Loop& loop : bowel_) {
            const double wall = organ(p, loop.centre, loop.radii);
            if (wall > softness_mm) continue;
            brush.paint(wall, 50.0);
            brush.paint(wall + 2.5, loop.content_hu);
        }
        if (p[2] > -10.0) paint_chest(brush, p, torso, liver_distance_mm);
        paint_organs(brush, p);
    }
    if (p[1] > 20.0 && std::abs(p[0]) < 70.0) paint_spine(brush, p);
    brush.paint(liver_distance_mm, parenchyma_hu_);
    return brush.hu();
}

Vec3 PhantomBody::first_point_inside(const Vec3& from, const Vec3& to) const {
    for (int step = 0; step < 200; ++step) {
        const Vec3 p = from + (to - from) * (step / 200.0);
        if (liver_distance_mm(p) < -5.0) return p;
    }
    return to;
}

Vec3 PhantomBody::portal_entry() const {
    return first_point_inside({-5, 30, -50}, {-60, 2, 0});
}

Vec3 PhantomBody::hepatic_outlet() const {
    return first_point_inside({-20, 44, 48}, {-60, 0, 20});
}

}  // namespace hepatica
