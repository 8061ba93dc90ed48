// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/screenshot.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkNew.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace hepatica::testing {
namespace {

constexpr int tile = 16;

vtkNew<vtkImageData> image_of(const Picture& picture) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(picture.rgb.begin(), picture.rgb.end(),
              static_cast<std::uint8_t*>(image->GetScalarPointer()));
    return image;
}

double mean_in_tile(vtkImageData& image, int left, int top) {
    const int* size = image.GetDimensions();
    const int right = std::min(left + tile, size[0]);
    const int bottom = std::min(top + tile, size[1]);
    double sum = 0.0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const auto* rgb = static_cast<const std::uint8_t*>(image.GetScalarPointer(x, y, 0));
            sum += rgb[0] + rgb[1] + rgb[2];
        }
    return sum / (3.0 * tile * tile);
}

}  // namespace

double worst_tile_difference(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height) return 255.0;
    vtkNew<vtkImageDifference> difference;
    difference->SetInputData(image_of(a));
    difference->SetImageData(image_of(b));
    difference->SetThreshold(8);
    difference->Update();
    double worst = 0.0;
    // Tiles overlap by half, so that a mark on the border of two counts whole in a third.
    for (int y = 0; y < a.height; y += tile / 2)
        for (int x = 0; x < a.width; x += tile / 2)
            worst = std::max(worst, mean_in_tile(*difference->GetOutput(), x, y));
    return worst;
}

bool look_alike(const Picture& a, const Picture& b) {
    return worst_tile_difference(a, b) < unnoticed_difference;
}

void expect_matches_baseline(const Picture& picture, const std::string& name) {
    const std::filesystem::path baseline =
        std::filesystem::path(HEPATICA_BASELINES) / (name + ".png");
    if (std::getenv("HEPATICA_UPDATE_BASELINES")) return write_png(baseline, picture);
    const double difference = worst_tile_difference(picture, read_png(baseline));
    if (difference < unnoticed_difference) return;
    const std::filesystem::path shown = std::filesystem::absolute(name + "_differs.png");
    write_png(shown, picture);
    ADD_FAILURE() << "the picture differs from " << baseline << " by " << difference
                  << " of 255 in its worst tile; it is in " << shown;
}

}  // namespace hepatica::testing
