// SPDX-License-Identifier: GPL-3.0-or-later
// Widget that shows a VTK render window in Qt. Passes mouse and wheel events to a MouseTool and
// keys to a KeyTool, in pixels of the picture. UI thread only.
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
#include "ui/calm_after_play.h"
#include "ui/canvas.h"
#include "ui/key_tool.h"
#include "ui/mouse_tool.h"
#include "ui/view_focus.h"

namespace hepatica {

// Durations for one picture since its painting began [ms].
struct PictureTime {
    double on_screen_ms = 0.0;  // until it has reached the screen
    // The processor's part, which the simulation must leave free: all of it without a graphics
    // card.
    double processor_ms = 0.0;
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
    // What the hand still does for a moment has no effect.
    void play_ended() { calm_.play_ended(); }
    // The mouse has another mode or tool. If it was chosen by a key, the aim is shown at once,
    // because keys will lead.
    void mode_chosen();
    const ViewFocus& focus_mark() const { return *focus_; }

    // Adds a callback that is called for each picture when it has reached the screen.
    void on_picture(std::function<void(const PictureTime&)> callback) {
        on_picture_.push_back(std::move(callback));
    }
    // Time the next picture is to wait [ms], 0 for none. Without a graphics card the simulation
    // needs the processor too: pictures then take half of the time, but come at least 20 times a
    // second if possible.
    int wait_before_picture_ms() const;

    // Renderer name from the OpenGL driver; empty before the first picture.
    const std::string& renderer_name() const { return renderer_name_; }

    // Shows a newer frame; draws only if it looks different.
    void show_frame(const Frame& frame);
    // To be called after any other change of scene or camera. While pictures change, the legend
    // keeps its corner, and without a graphics card they are drawn without smoothing; a last one
    // follows when they are at rest.
    void draw_again();
    // As draw_again(), for changes led from the slices: without a graphics card only once they
    // rest, and some four times a second while they do not, so that the slices, which the user
    // looks at, come first.
    void draw_soon();

    // Draws a picture now and reads it, at the screen's resolution and smoothing.
    QImage drawn() { return canvas_->drawn(); }
    // The same with the best smoothing.
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
    // The mouse is used: lets go of whatever the keys hold.
    void take_from_keys();
    void show_aim();
    bool software() const;
    void make_current();
    CanvasPainter painter();
    void begin(QOpenGLContext& context);
    unsigned draw(const QSize& pixels);
    void picture_shown();

    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    std::unique_ptr<SceneView> scene_;
    std::unique_ptr<MouseTool> mouse_;
    CalmAfterPlay calm_;
    std::unique_ptr<KeyTool> keys_;
    bool key_is_down_ = false;  // one that came to this widget first, also if it is a shortcut
    Canvas* canvas_ = nullptr;
    ViewFocus* focus_ = nullptr;
    std::vector<std::function<void(const PictureTime&)>> on_picture_;
    std::function<void(const SurfacePick&)> hover_;
    std::string renderer_name_;
    QTimer rest_timer_;
    QTimer soon_timer_;          // a picture is due when it fires
    QElapsedTimer since_asked_;  // since soon_timer_ was set for that picture
    QElapsedTimer since_painting_;
    PictureTime last_;           // the last picture that has reached the screen
    double submitted_ms_ = 0.0;  // of the picture being painted
};

}  // namespace hepatica
