// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_picture.h"

#include <algorithm>
#include <array>

#include "render/palette.h"

namespace hepatica {
namespace {

constexpr int least_numbered = 40;  // pixels of a segment that leave room for its number

QImage grey_image(const std::vector<std::uint8_t>& grey, int columns, int rows) {
    QImage picture(columns, rows, QImage::Format_RGB32);
    std::size_t i = 0;
    for (int row = 0; row < rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
        for (int column = 0; column < columns; ++column, ++i)
            line[column] = qRgb(grey[i], grey[i], grey[i]);
    }
    return picture;
}

// Blends in the colours of the vascular systems and of painted voxels.
void lay_systems(QImage& picture, const std::vector<std::uint8_t>& labels, double opacity) {
    std::array<Colour, 256> tint{};
    for (const VascularSystem system : vascular_systems)
        tint[static_cast<std::size_t>(number_of(system))] = palette::vessel_system(system);
    tint[painted_label] = {colour_of_marks.redF(), colour_of_marks.greenF(),
                           colour_of_marks.blueF()};
    std::size_t i = 0;
    for (int row = 0; row < picture.height(); ++row) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
        for (int column = 0; column < picture.width(); ++column, ++i) {
            if (labels[i] != 0) line[column] = tinted(line[column], tint[labels[i]], opacity);
        }
    }
}

}  // namespace

SlicePicture picture_of(const SliceScene& scene, const SliceStack& slices, int slice) {
    SlicePicture picture;
    picture.image = grey_image(grey_slice(scene.ct(), slices, slice, scene.window()),
                               slices.columns(), slices.rows());
    if (scene.shows_segments()) {
        const auto segments = label_slice(scene.segments(), slices, slice);
        lay_segments(picture.image, segments);
        picture.segment_numbers = segment_numbers(segments, slices.columns(), least_numbered);
    }
    if (scene.opacity() > 0.0 && !scene.shown_systems().voxels.empty())
        lay_systems(picture.image, label_slice(scene.shown_systems(), slices, slice),
                    scene.opacity());
    if (!scene.tumours().organs().voxels.empty()) {
        auto numbers = label_slice(scene.tumours().organs(), slices, slice);
        std::ranges::transform(numbers, numbers.begin(), [](std::uint8_t label) {
            return static_cast<std::uint8_t>(tumour_of(label));
        });
        lay_tumours(picture.image, numbers);
    }
    return picture;
}

}  // namespace hepatica
