// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/screenshot.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "render/image_compare.h"

namespace hepatica::testing {

void expect_matches_baseline(const Picture& picture, const std::string& name) {
    const std::filesystem::path baseline =
        std::filesystem::path(HEPATICA_BASELINES) / (name + ".png");
    if (std::getenv("HEPATICA_UPDATE_BASELINES")) return write_png(baseline, picture);
    const PictureDifference difference = compare_pictures(picture, read_png(baseline));
    const bool alike =
        difference.same_size && difference.mean < 2.0 && difference.different_share < 0.004;
    if (alike) return;
    const std::filesystem::path shown = std::filesystem::absolute(name + "_differs.png");
    write_png(shown, picture);
    ADD_FAILURE() << "the picture differs from " << baseline << ": mean " << difference.mean
                  << " of 255, visibly different pixels " << 100.0 * difference.different_share
                  << " %; it is in " << shown;
}

}  // namespace hepatica::testing
