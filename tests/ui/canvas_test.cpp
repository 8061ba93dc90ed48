// SPDX-License-Identifier: GPL-3.0-or-later
// Both ways of a picture onto the screen, whatever draws here: the same picture, upright, once.
#include <gtest/gtest.h>

#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <array>
#include <memory>
#include <optional>

#include "tests/ui/window_test.h"
#include "ui/hidden_context.h"
#include "ui/image_canvas.h"
#include "ui/surface_canvas.h"
#include "ui/vtk_widget.h"

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

// Of two views each frees its own: the names of what it drew are those of other things in the
// other.
TEST_P(CanvasTest, MakesItsOwnContextCurrentOnceItHasDrawn) {
    TwoHalves first_halves, second_halves;
    QWidget first_view, second_view;
    const auto new_canvas = [](QWidget& view, TwoHalves& halves) -> Canvas* {
        view.resize(200, 100);
        if (GetParam())
            return new ImageCanvas(view, std::make_unique<HiddenContext>(), halves.painter());
        return new SurfaceCanvas(view, halves.painter());
    };
    Canvas* first = new_canvas(first_view, first_halves);
    Canvas* second = new_canvas(second_view, second_halves);
    for (QWidget* view : {&first_view, &second_view}) view->show();
    first->make_current();  // before its first picture there is nothing to be freed
    ASSERT_TRUE(wait_for([&] { return first_halves.shown >= 1 && second_halves.shown >= 1; }));
    first->make_current();
    const QOpenGLContext* of_first = QOpenGLContext::currentContext();
    ASSERT_NE(of_first, nullptr);
    second->make_current();
    EXPECT_NE(QOpenGLContext::currentContext(), of_first);
    first->make_current();
    EXPECT_EQ(QOpenGLContext::currentContext(), of_first);
    first->finish();
    second->finish();
}

// A gap that is bridged while the other of two views drew last.
TEST(TwoViews, FreeWhatIsTakenOutOfEachInItsOwnContext) {
    const auto nothing = [] {
        return MouseTool::Callbacks{[](const Command&) {},
                                    [](const SurfacePick&) {},
                                    [](const SurfacePick&) {},
                                    [](const SurfacePick&) {},
                                    [](int) {},
                                    [](const SurfacePick&) { return Vec3(Vec3::Zero()); },
                                    [](MouseMode, const std::optional<std::array<Vec3, 2>>&) {}};
    };
    VtkWidget first(nothing()), second(nothing());
    first.scene().set_bridges({{{Vec3(-5, 0, 0), Vec3(5, 0, 0)}, "50 %", false}});
    first.drawn();
    const QOpenGLContext* of_first = QOpenGLContext::currentContext();
    second.drawn();
    if (of_first == nullptr || QOpenGLContext::currentContext() == of_first)
        GTEST_SKIP() << "the views leave no context of their own";
    first.scene().set_bridges({});
    EXPECT_EQ(QOpenGLContext::currentContext(), of_first);
}

INSTANTIATE_TEST_SUITE_P(ImageAndSurface, CanvasTest, ::testing::Values(true, false));

}  // namespace
}  // namespace hepatica
