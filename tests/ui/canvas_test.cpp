// SPDX-License-Identifier: GPL-3.0-or-later
// Both ways of a picture onto the screen, whatever draws here: the same picture, upright, once.
#include <gtest/gtest.h>

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <memory>

#include "tests/ui/window_test.h"
#include "ui/hidden_context.h"
#include "ui/image_canvas.h"
#include "ui/surface_canvas.h"

namespace hepatica {
namespace {

using testing::wait_for;

// Draws a red lower and a blue upper half.
class TwoHalves {
  public:
    CanvasPainter painter() {
        return {.begin = [this](QOpenGLContext& context) { ++begun, gl_ = context.functions(); },
                .draw = [this](const QSize& pixels) { return draw(pixels); },
                .shown = [this] { ++shown; },
                .end = [this] { ++ended, target_.reset(); }};
    }
    int begun = 0, drawn = 0, shown = 0, ended = 0;

  private:
    unsigned draw(const QSize& pixels) {
        ++drawn;
        target_ = std::make_unique<QOpenGLFramebufferObject>(pixels);
        target_->bind();
        gl_->glDisable(GL_SCISSOR_TEST);
        gl_->glClearColor(0, 0, 1, 1);
        gl_->glClear(GL_COLOR_BUFFER_BIT);
        gl_->glEnable(GL_SCISSOR_TEST);
        gl_->glScissor(0, 0, pixels.width(), pixels.height() / 2);
        gl_->glClearColor(1, 0, 0, 1);
        gl_->glClear(GL_COLOR_BUFFER_BIT);
        gl_->glDisable(GL_SCISSOR_TEST);
        return target_->handle();
    }
    QOpenGLFunctions* gl_ = nullptr;
    std::unique_ptr<QOpenGLFramebufferObject> target_;
};

class CanvasTest : public ::testing::TestWithParam<bool> {};

TEST_P(CanvasTest, BringsThePictureUprightOntoTheScreenAndEndsOnce) {
    TwoHalves halves;
    QWidget view;
    view.resize(200, 100);
    Canvas* canvas = nullptr;
    if (GetParam())
        canvas = new ImageCanvas(view, std::make_unique<HiddenContext>(), halves.painter());
    else
        canvas = new SurfaceCanvas(view, halves.painter());
    canvas->widget().setGeometry(view.rect());
    view.show();
    ASSERT_TRUE(wait_for([&] { return halves.shown >= 1; }));
    EXPECT_EQ(halves.begun, 1);
    const QImage image = canvas->drawn();
    ASSERT_EQ(image.size(), QSize(200, 100) * view.devicePixelRatioF());
    const int middle = image.width() / 2;
    EXPECT_EQ(image.pixelColor(middle, 5), QColor(Qt::blue));
    EXPECT_EQ(image.pixelColor(middle, image.height() - 6), QColor(Qt::red));
    const int shown = halves.shown, drawn = halves.drawn;
    canvas->redraw();
    ASSERT_TRUE(wait_for([&] { return halves.shown > shown; }));
    EXPECT_GT(halves.drawn, drawn);
    canvas->finish();
    canvas->finish();
    EXPECT_EQ(halves.ended, 1);
}

INSTANTIATE_TEST_SUITE_P(ImageAndSurface, CanvasTest, ::testing::Values(true, false));

}  // namespace
}  // namespace hepatica
