// SPDX-License-Identifier: GPL-3.0-or-later
// A small view without a display, and the pictures that it draws.
#pragma once

#include <gtest/gtest.h>

#include "render/osmesa_context.h"
#include "render/picture.h"
#include "render/scene_view.h"

namespace hepatica::testing {

class ScenePictures : public ::testing::Test {
  protected:
    static constexpr int width = 320, height = 240;

    Picture picture() {
        view_.render();
        return read_picture(context_.window());
    }
    Picture picture_of(const Frame& frame) {
        view_.show(frame);
        return picture();
    }

    OsmesaContext context_{width, height};
    SceneView view_{context_.window()};
};

}  // namespace hepatica::testing
