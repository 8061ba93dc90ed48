// SPDX-License-Identifier: GPL-3.0-or-later
// The bridge between Qt 6 and VTK: a widget on whose canvas a VTK render window draws.
// Mouse and wheel go to a MouseTool, keys to a KeyTool, already in the picture's pixels.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/scene_view.h"
#include "ui/canvas.h"
#include "ui/key_tool.h"
#include "ui/mouse_tool.h"
#include "ui/view_focus.h"

namespace hepatica {

// What one picture took [ms] since its painting began.
struct PictureTime {
    double on_screen_ms = 0.0;  // until it has reached the screen
    double processor_ms = 0.0;  // the part that a graphics card does not do, and that the
                                // simulation has to leave: all of it where there is no card
};

class VtkWidget : public QWidget {
  public:
    explicit VtkWidget(MouseTool::Callbacks callbacks, QWidget* parent = nullptr);
    ~VtkWidget() override;

    SceneView& scene() { return *scene_; }
    MouseTool& mouse() { return *mouse_; }
    KeyTool& keys() { return *keys_; }
    // Of what mouse or keys pull or draw.
    void let_go();
    const ViewFocus& focus_mark() const { return *focus_; }

    // Each of these is called for each picture when it has reached the screen.
    void on_picture(std::function<void(const PictureTime&)> callback) {
        on_picture_.push_back(std::move(callback));
    }
    // How long the next picture is to wait [ms], 0 for not at all. Without a graphics card the
    // simulation needs the processor as well: pictures then take half of the time, but never come
    // less often than 20 times a second if they can.
    int wait_before_picture_ms() const;

    // What the OpenGL driver calls itself; empty until the first painted frame.
    const std::string& renderer_name() const { return renderer_name_; }

    // Shows a newer frame; draws only if it looks different.
    void show_frame(const Frame& frame);
    // After every other change of the scene or the camera. Without a graphics card the picture is
    // drawn plainly while it moves and smoothed as soon as it rests.
    void draw_again();
    // After what is led in the slices: without a graphics card not more than 20 times a second, so
    // that the slices, which the person looks at, come first.
    void draw_soon();

    // Draws now, as the next picture on the screen, and reads it, at the screen's own resolution.
    QImage drawn() { return canvas_->drawn(); }
    // The same as finely as it can be drawn.
    QImage picture();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    Pixel pixel_of(const QPointF& point) const;
    // The mouse is used: whatever keys hold is let go.
    void take_from_keys();
    void show_aim();
    bool software() const;
    CanvasPainter painter();
    void begin(QOpenGLContext& context);
    unsigned draw(const QSize& pixels);
    void picture_shown();

    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    std::unique_ptr<SceneView> scene_;
    std::unique_ptr<MouseTool> mouse_;
    std::unique_ptr<KeyTool> keys_;
    Canvas* canvas_ = nullptr;
    ViewFocus* focus_ = nullptr;
    std::vector<std::function<void(const PictureTime&)>> on_picture_;
    std::function<void(const SurfacePick&)> hover_;
    std::string renderer_name_;
    QTimer rest_timer_;
    QTimer soon_timer_;  // a picture is due when it ends
    QElapsedTimer since_painting_;
    PictureTime last_;           // of the last picture that has reached the screen
    double submitted_ms_ = 0.0;  // of the picture that is painted
};

}  // namespace hepatica
