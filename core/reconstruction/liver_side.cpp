// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/liver_side.h"

#include <algorithm>
#include <limits>

#include "core/patient/patient_case.h"

namespace hepatica {
namespace {

constexpr int body_hu = -300;      // denser than lungs, bowel gas and the air around
constexpr int every = 3;           // voxel in each direction: the middle of millions needs no more
constexpr double far_aside = 0.1;  // as a share of the body's width

// Of points along the patient's left.
struct Extent {
    double sum = 0.0, count = 0.0;
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();

    void add(double x) {
        sum += x;
        count += 1.0;
        least = std::min(least, x);
        most = std::max(most, x);
    }
    double middle() const { return sum / count; }
};

// Calls see(position) for one voxel of `every` that `chosen` accepts.
template <class Image, class Chosen, class See>
void visit(const Image& image, const Chosen& chosen, const See& see, const Job& job) {
    const auto& [nx, ny, nz] = image.grid.dims;
    for (int z = 0; z < nz; z += every) {
        job.throw_if_cancelled();
        for (int y = 0; y < ny; y += every)
            for (int x = 0; x < nx; x += every)
                if (chosen(image.at(x, y, z))) see(image.grid.to_mm(x, y, z));
    }
}

}  // namespace

bool lies_on_the_left(const Mask& organs, const Volume& ct, const Job& job) {
    Extent liver, height, body;
    visit(
        organs, [](std::uint8_t label) { return label == organ_label::liver; },
        [&](const Vec3& at) {
            liver.add(at.x());
            height.add(at.z());
        },
        job);
    if (liver.count == 0.0) return false;
    visit(
        ct, [](std::int16_t hu) { return hu > body_hu; },
        [&](const Vec3& at) {
            if (at.z() >= height.least && at.z() <= height.most) body.add(at.x());
        },
        job);
    if (body.count == 0.0) return false;
    return liver.middle() - body.middle() > far_aside * (body.most - body.least);
}

}  // namespace hepatica
