// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_view.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include "render/osmesa_context.h"
#include "render/picture.h"
#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

TEST(SceneView, draws_the_tree) {
    OsmesaContext context(1280, 960);
    SceneView view(context.window());
    Frame frame = testing::fake_frame(0.1, 1.6);
    view.show(frame);
    view.set_caption("fake tree");
    view.render();
    write_png("/tmp/window_fake.png", read_picture(context.window()));
    for (int i = 0; i < 5; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        view.show(testing::fake_frame(0.1 * i, 0.4 * i));
        view.render();
        std::printf("%s %.1f ms\n", view.renderer_name().c_str(),
                    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                        .count());
    }
}

}  // namespace
}  // namespace hepatica
