// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/segmentation/random_abdomen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/job.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/phantom/phantom_random.h"

namespace hepatica::test {

namespace {

constexpr double fat_hu = -100.0;
constexpr double lung_hu = -860.0;
constexpr double bone_hu = 420.0;

// About the signed distance to an ellipsoid (Quilez): exact on it, the right sign everywhere.
struct Ellipsoid {
    Vec3 centre, radii;

    double distance(const Vec3& p) const {
        const Vec3 q = (p - centre).cwiseQuotient(radii);
        const double k0 = q.norm(), k1 = q.cwiseQuotient(radii).norm();
        return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
    }
};

struct Capsule {
    Vec3 begin, end;
    double begin_radius, end_radius;

    double distance(const Vec3& p) const {
        const Vec3 along = end - begin;
        const double share = std::clamp((p - begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (p - begin - share * along).norm() -
               (begin_radius + share * (end_radius - begin_radius));
    }
};

double column(const Vec3& p, double x, double y, double radius_x, double radius_y) {
    return Ellipsoid{{x, y, 0.0}, {radius_x, radius_y, 1e6}}.distance({p.x(), p.y(), 0.0});
}

double smooth_union(double a, double b, double width) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * h * h * width;
}

double smooth_difference(double a, double b, double width) {
    return -smooth_union(-a, b, width);
}

// Three waves along three directions: a smooth field between about -1 and 1.
class Waves {
  public:
    Waves(PhantomRandom& random, double shortest_mm, double longest_mm) {
        for (Wave& wave : waves_) {
            Vec3 direction = random.point({-1, -1, -1}, {1, 1, 1});
            direction /= std::max(direction.norm(), 0.1);
            wave.number =
                2.0 * std::numbers::pi / random.uniform(shortest_mm, longest_mm) * direction;
            wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
    }
    double at(const Vec3& p) const {
        double sum = 0.0;
        for (const Wave& wave : waves_) sum += std::sin(wave.number.dot(p) + wave.phase);
        return sum / static_cast<double>(waves_.size());
    }

  private:
    struct Wave {
        Vec3 number;
        double phase = 0.0;
    };
    std::array<Wave, 3> waves_;
};

// A tumour, a vessel or a loop of bowel with what it shows.
template <class Shape>
struct Filled {
    Shape shape;
    double hu = 0.0;
};

// Everything that is drawn of one body. Ranges are listed in the header.
class Body {
  public:
    explicit Body(PhantomRandom& random)
        : random_(random),
          bend_{Waves(random, 60, 120), Waves(random, 60, 120), Waves(random, 60, 120)},
          field_(random, 90, 200),
          lobules_(random, 12, 22) {
        parenchyma_hu = between(85, 135);
        choose_liver();
        choose_neighbours();
        choose_contents();
    }

    // The tissue of a place, its organ, and its intensity with borders softened over softness_mm.
    double paint(const Vec3& p, double softness_mm, AbdomenOrgan& organ) const;

    double parenchyma_hu = 0.0;

  private:
    double between(double low, double high) { return random_.uniform(low, high); }
    void choose_liver();
    void choose_neighbours();
    void choose_contents();
    void add_vessels();
    double liver_distance(const Vec3& p) const;

    PhantomRandom& random_;
    std::array<Waves, 3> bend_;
    Waves field_, lobules_;
    double size_ = 1.0, wall_fat_mm_ = 15.0, wall_muscle_mm_ = 12.0;
    Ellipsoid right_lobe_{}, left_lobe_{}, tail_{}, visceral_{}, gallbladder_{};
    Capsule tail_bridge_{};
    bool has_tail_ = false;
    Ellipsoid spleen_{}, stomach_{}, heart_{};
    std::array<Ellipsoid, 2> kidneys_{};
    std::vector<Capsule> pancreas_;
    double spleen_gap_ = 0, stomach_gap_ = 0, heart_gap_ = 0, kidney_gap_ = 0, pancreas_gap_ = 0,
           wall_gap_ = 0;
    double spleen_hu_ = 0, myocardium_hu_ = 0, blood_hu_ = 0, myocardium_mm_ = 0,
           stomach_wall_hu_ = 0, stomach_hu_ = 0, pancreas_hu_ = 0, kidney_hu_ = 0, cava_hu_ = 0,
           aorta_hu_ = 0, muscle_hu_ = 0, bile_hu_ = 0, cava_radius_ = 0;
    double field_hu_ = 0, dark_back_hu_ = 0, dark_back_y_ = 0;
    std::vector<Filled<Ellipsoid>> tumours_, bowel_;
    std::vector<Filled<Capsule>> vessels_;
};

void Body::choose_liver() {
    size_ = between(0.9, 1.1);
    wall_fat_mm_ = between(5, 28);
    wall_muscle_mm_ = between(9, 15);
    right_lobe_ = {random_.point({-74, 2, -14}, {-60, 14, 6}),
                   random_.point({52, 62, 62}, {66, 76, 80})};
    left_lobe_ = {random_.point({-22, -46, 16}, {2, -28, 32}),
                  random_.point({50, 26, 24}, {92, 40, 42})};
    has_tail_ = random_.uniform() < 0.35;  // a left lobe that bends back round the spleen
    tail_ = {random_.point({66, -22, 26}, {92, 14, 46}), random_.point({22, 30, 13}, {34, 44, 22})};
    tail_bridge_ = {left_lobe_.centre + Vec3(20, 4, 0), tail_.centre, between(16, 24),
                    between(12, 20)};
    visceral_ = {random_.point({10, 30, -60}, {26, 42, -48}),
                 random_.point({64, 56, 58}, {76, 66, 70})};
    gallbladder_ = {random_.point({-54, -30, -68}, {-40, -18, -54}),
                    random_.point({12, 15, 18}, {18, 24, 30})};
}

void Body::choose_neighbours() {
    spleen_ = {random_.point({84, 28, -10}, {104, 50, 34}),
               random_.point({24, 38, 38}, {38, 54, 62})};
    stomach_ = {random_.point({36, -26, -12}, {60, -8, 12}),
                random_.point({28, 30, 34}, {48, 46, 52})};
    heart_ = {random_.point({8, -48, 84}, {34, -30, 98}),
              random_.point({48, 40, 38}, {64, 52, 48})};
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -1.0 : 1.0;
        kidneys_[side] = {Vec3(sign * between(54, 68), between(50, 62), between(-80, -48)),
                          random_.point({22, 20, 44}, {30, 28, 58})};
    }
    // From the duodenum, beside the porta hepatis, to the spleen's hilum.
    const Vec3 head = random_.point({-46, -8, -54}, {-26, 16, -30});
    const Vec3 neck = random_.point({0, -12, -36}, {16, 6, -20});
    const Vec3 end = random_.point({52, 16, -14}, {76, 34, 8});
    pancreas_ = {{head + Vec3(-8, 6, -30), head, between(12, 17), between(13, 20)},
                 {head, neck, between(12, 18), between(8, 12)},
                 {neck, end, between(8, 12), between(8, 13)}};
    for (double* gap :
         {&spleen_gap_, &stomach_gap_, &heart_gap_, &kidney_gap_, &pancreas_gap_, &wall_gap_})
        *gap = between(-1, 3);
    spleen_hu_ = parenchyma_hu + between(-8, 25);
    myocardium_hu_ = parenchyma_hu + between(-15, 20);
    blood_hu_ = parenchyma_hu + between(15, 60);
    myocardium_mm_ = between(4, 11);
    stomach_wall_hu_ = between(60, 110);
    stomach_hu_ = between(0, 60);
    pancreas_hu_ = parenchyma_hu + between(-28, 3);
    kidney_hu_ = parenchyma_hu + between(55, 110);
    cava_hu_ = parenchyma_hu + between(-25, 30);
    cava_radius_ = between(8, 14);
    aorta_hu_ = parenchyma_hu + between(15, 60);
    muscle_hu_ = between(45, 68);
    bile_hu_ = between(2, 22);
}

void Body::add_vessels() {
    const double portal_hu = parenchyma_hu + between(20, 70);
    const double hepatic_hu = parenchyma_hu + between(20, 70);
    const Vec3 hilum(-18, 14, -18), right = right_lobe_.centre, left = left_lobe_.centre;
    vessels_.push_back({{hilum + Vec3(24, 16, -30), hilum, 6.5, 6}, portal_hu});
    vessels_.push_back({{hilum, right + Vec3(10, -5, -10), 6, 4}, portal_hu});
    vessels_.push_back({{hilum, left + Vec3(5, 4, -4), 5, 3}, portal_hu});
    for (int i = 0; i < 6; ++i)
        vessels_.push_back({{right + Vec3(10, -5, -10),
                             right + random_.point({-45, -50, -50}, {25, 50, 50}), 3.5, 1.5},
                            portal_hu});
    const Vec3 outlet(-22, 36, 46);
    for (int i = 0; i < 3; ++i)
        vessels_.push_back(
            {{outlet, right + random_.point({-40, -45, -45}, {20, 20, 20}), 6, 2}, hepatic_hu});
    vessels_.push_back({{outlet, left + Vec3(20, 0, 0), 5, 2}, hepatic_hu});
}

void Body::choose_contents() {
    add_vessels();
    const int tumours = static_cast<int>(between(0, 6));
    for (int i = 0; i < tumours; ++i) {
        const bool on_the_right = random_.uniform() < 0.7;
        const Ellipsoid& lobe = on_the_right ? right_lobe_ : left_lobe_;
        const Vec3 at = lobe.centre +
                        0.8 * lobe.radii.cwiseProduct(random_.point({-.6, -.6, -.6}, {.6, .6, .6}));
        const double radius = between(5, on_the_right ? 38 : 20);
        tumours_.push_back({{at, radius * random_.point({.8, .8, .8}, {1.1, 1.1, 1.1})},
                            parenchyma_hu - between(20, 70)});
    }
    for (int i = 0; i < 34; ++i)
        bowel_.push_back({{random_.point({-110, -75, -120}, {110, 30, -40}),
                           random_.point({10, 9, 12}, {20, 16, 24})},
                          random_.uniform() < 0.4 ? -800.0 : between(5, 70)});
    field_hu_ = between(0, 10);
    if (random_.uniform() < 0.3) dark_back_hu_ = between(10, 28);
    dark_back_y_ = between(10, 45);
}

double Body::liver_distance(const Vec3& p) const {
    if (p.x() < -145 || p.x() > 140 || p.z() > 95 || p.z() < -100) return 50.0;
    const Vec3 q = p + 2.5 * Vec3(bend_[0].at(p), bend_[1].at(p), bend_[2].at(p));
    double liver = smooth_union(right_lobe_.distance(q), left_lobe_.distance(q), 28.0);
    if (has_tail_)
        liver = smooth_union(liver, std::min(tail_.distance(q), tail_bridge_.distance(q)), 18.0);
    liver = smooth_difference(liver, visceral_.distance(q), 20.0);
    liver = smooth_difference(liver, column(q, 2, 62, 38, 34), 14.0);
    return smooth_difference(liver, gallbladder_.distance(q), 6.0);
}

// Paints tissue over what is there, softening the border; the organ is that of the last that holds
// the place.
class Brush {
  public:
    Brush(double softness_mm, AbdomenOrgan& organ) : scale_(1.0 / softness_mm), organ_(organ) {}

    void paint(double distance_mm, double tissue_hu, AbdomenOrgan organ) {
        const double share = std::clamp(0.5 - distance_mm * scale_, 0.0, 1.0);
        hu_ += share * (tissue_hu - hu_);
        if (distance_mm < 0.0) organ_ = organ;
    }
    double hu() const { return hu_; }

  private:
    double scale_;
    double hu_ = -1000.0;
    AbdomenOrgan& organ_;
};

void paint_bones(Brush& brush, const Vec3& p, double inner) {
    const double slanted = (p.z() + 0.45 * p.y()) / 27.0;
    const double along_z = 27.0 * std::abs(slanted - std::round(slanted)) - 5.0;
    const double rib = std::max({along_z, std::abs(inner - 5.0) - 4.0, -60.0 - p.y()});
    brush.paint(rib, bone_hu, AbdomenOrgan::wall);
    brush.paint(rib + 2.0, 200.0, AbdomenOrgan::wall);
    const double spine = column(p, 0, 60, 22, 17);
    brush.paint(column(p, 0, 84, 62, 19), 58.0, AbdomenOrgan::wall);
    brush.paint(spine, 480.0, AbdomenOrgan::wall);
    brush.paint(spine + 2.5, 190.0, AbdomenOrgan::wall);
    brush.paint(column(p, 0, 84, 14, 12), bone_hu, AbdomenOrgan::wall);
}

double Body::paint(const Vec3& at, double softness_mm, AbdomenOrgan& organ) const {
    using enum AbdomenOrgan;
    organ = none;
    Brush brush(softness_mm, organ);
    const Vec3 p = at / size_;
    const double inner = column(p, 0, 2, 132, 84);  // the wall's inside
    const double outside = inner - wall_muscle_mm_ - wall_fat_mm_;
    if (outside > softness_mm) return brush.hu();
    brush.paint(outside, fat_hu, none);
    brush.paint(inner - wall_muscle_mm_, muscle_hu_, wall);
    brush.paint(inner, fat_hu, none);
    const double from_liver = std::max(liver_distance(p), inner + std::max(wall_gap_, 0.0));
    for (const Filled<Ellipsoid>& loop : bowel_) {
        brush.paint(std::max(loop.shape.distance(p), 1.0 - from_liver), 50.0, bowel);
        brush.paint(std::max(loop.shape.distance(p), 1.0 - from_liver) + 2.5, loop.hu, bowel);
    }
    const double from_dome = std::abs(p.x()) - 68.0;
    const double base = 58.0 - (from_dome * from_dome + p.y() * p.y()) / 150.0 - p.z();
    if (p.z() > -30.0) {  // diaphragm and lungs
        brush.paint(std::max({base - 3.0, inner, -from_liver}), muscle_hu_, wall);
        brush.paint(std::max({base, inner + 2.0, 3.0 - from_liver}), lung_hu, none);
    }
    const auto beside = [&](double distance, double gap) {
        return std::max(distance, gap - from_liver);
    };
    const double heart_wall = beside(heart_.distance(p), heart_gap_);
    brush.paint(heart_wall - 1.5, fat_hu, none);
    brush.paint(heart_wall, myocardium_hu_, heart);
    brush.paint(heart_wall + myocardium_mm_, blood_hu_, heart);
    for (const Capsule& part : pancreas_)
        brush.paint(beside(part.distance(p) + 1.5 * lobules_.at(p), pancreas_gap_), pancreas_hu_,
                    pancreas);
    const double stomach_outside = std::max(beside(stomach_.distance(p), stomach_gap_), inner + 2);
    brush.paint(stomach_outside, stomach_wall_hu_, stomach);
    brush.paint(stomach_outside + 4.0, stomach_hu_, stomach);
    brush.paint(std::max(stomach_outside + 4.0, p.y() + 36.0), -900.0, stomach);
    for (const Ellipsoid& side : kidneys_)
        brush.paint(beside(side.distance(p), kidney_gap_), kidney_hu_, kidney);
    brush.paint(std::max(beside(spleen_.distance(p), spleen_gap_), inner + 1.0), spleen_hu_,
                spleen);
    if (p.y() > 15.0 || std::abs(inner) < 30.0) paint_bones(brush, p, inner);
    brush.paint(column(p, 12, 34, 10.5, 10.5), aorta_hu_, cava);
    brush.paint(beside(gallbladder_.distance(p) + 1.0, 0.0), bile_hu_, none);
    brush.paint(from_liver, parenchyma_hu + field_hu_ * field_.at(p), liver);
    for (const Filled<Ellipsoid>& tumour : tumours_)
        brush.paint(std::max(tumour.shape.distance(p), from_liver), tumour.hu, liver);
    for (const Filled<Capsule>& vessel : vessels_)
        if (from_liver < 4.0)
            brush.paint(vessel.shape.distance(p), vessel.hu, from_liver < 0.0 ? liver : none);
    brush.paint(std::max(column(p, -22, 38, cava_radius_, cava_radius_), p.z() - 66.0), cava_hu_,
                cava);
    if (brush.hu() > 0.0 && dark_back_hu_ > 0.0)
        return brush.hu() - dark_back_hu_ / (1.0 + std::exp(-(at.y() - dark_back_y_) / 5.0));
    return brush.hu();
}

void add_noise(FloatVolume& image, double noise_hu, std::uint64_t seed) {
    FloatVolume noise(image.grid);
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
        noise.voxels[i] = normal_deviate(scrambled(seed) + i);
    Job job;
    gaussian_smooth(noise, Vec3(0.7, 0.7, 0.0).cwiseProduct(image.grid.spacing_mm), job);
    double squares = 0.0;
    for (const float v : noise.voxels) squares += static_cast<double>(v) * static_cast<double>(v);
    const auto scale = static_cast<float>(
        noise_hu / std::sqrt(squares / static_cast<double>(noise.voxels.size())));
    for (std::size_t i = 0; i < noise.voxels.size(); ++i)
        image.voxels[i] += scale * noise.voxels[i];
}

Grid grid_of(const RandomAbdomenOptions& options) {
    Vec3 low(-185, -132, -118), high(185, 132, 112);
    if (options.slab_mm > 0.0) {
        low.z() = -0.5 * options.slab_mm;
        high.z() = 0.5 * options.slab_mm;
    }
    Grid grid;
    grid.spacing_mm = options.spacing_mm;
    grid.origin_mm = low;
    for (int a = 0; a < 3; ++a)
        grid.dims[static_cast<std::size_t>(a)] =
            static_cast<int>((high[a] - low[a]) / options.spacing_mm[a]) + 1;
    return grid;
}

}  // namespace

std::string name_of(AbdomenOrgan organ) {
    static const std::array<const char*, static_cast<std::size_t>(AbdomenOrgan::count)> names{
        "none",     "liver",  "spleen", "heart", "stomach",
        "pancreas", "kidney", "cava",   "wall",  "bowel"};
    return names.at(static_cast<std::size_t>(organ));
}

RandomAbdomen random_abdomen(const RandomAbdomenOptions& options) {
    PhantomRandom random(scrambled(options.seed));
    const Body body(random);
    const double noise_hu = random.uniform(8, 22);
    const Grid grid = grid_of(options);
    RandomAbdomen made{Volume(grid), Mask(grid), Mask(grid), body.parenchyma_hu};
    FloatVolume image(grid);
    const double softness_mm = std::cbrt(grid.spacing_mm.prod());
    const std::size_t row = static_cast<std::size_t>(grid.dims[0]);
    parallel_blocks(grid.count(), row, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto [x, y, z] = grid.index_of(i);
            AbdomenOrgan organ{};
            image.voxels[i] =
                static_cast<float>(body.paint(grid.to_mm(x, y, z), softness_mm, organ));
            made.organs.voxels[i] = static_cast<std::uint8_t>(organ);
            made.liver.voxels[i] = organ == AbdomenOrgan::liver ? 1 : 0;
        }
    });
    Job job;
    gaussian_smooth(image, Vec3::Constant(0.7), job);
    add_noise(image, noise_hu, options.seed);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
        made.ct.voxels[i] =
            static_cast<std::int16_t>(std::lround(std::clamp(image.voxels[i], -1024.0f, 3071.0f)));
    return made;
}

}  // namespace hepatica::test
