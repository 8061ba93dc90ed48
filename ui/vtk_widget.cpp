// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vtk_widget.h"

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ui/core_words.h"
#include "ui/pixel_mapping.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace hepatica {
namespace {

MouseModifiers modifiers_of(const QInputEvent& event) {
    return {event.modifiers().testFlag(Qt::ShiftModifier),
            event.modifiers().testFlag(Qt::ControlModifier),
            event.modifiers().testFlag(Qt::AltModifier)};
}

std::optional<ViewKey> view_key_of(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Left:
            return ViewKey::left;
        case Qt::Key_Right:
            return ViewKey::right;
        case Qt::Key_Up:
            return ViewKey::up;
        case Qt::Key_Down:
            return ViewKey::down;
        case Qt::Key_Plus:
            return ViewKey::nearer;
        case Qt::Key_Minus:
            return ViewKey::farther;
        case Qt::Key_Home:
            return ViewKey::whole;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return ViewKey::enter;
        case Qt::Key_Escape:
            return ViewKey::escape;
        case Qt::Key_PageUp:
            return ViewKey::in;
        case Qt::Key_PageDown:
            return ViewKey::out;
        default:
            return std::nullopt;
    }
}

MouseButton button_of(const QMouseEvent& event) {
    return event.button() == Qt::LeftButton     ? MouseButton::left
           : event.button() == Qt::MiddleButton ? MouseButton::middle
                                                : MouseButton::right;
}

}  // namespace

VtkWidget::VtkWidget(MouseTool::Callbacks callbacks, QWidget* parent)
    : QWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      hover_(callbacks.hover) {
    window_->SetFrameBlitModeToNoBlit();
    // VTK frees what is taken out of the scene at once, between pictures, too.
    window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &VtkWidget::make_current);
    scene_ = std::make_unique<SceneView>(*window_);
    scene_->set_words([](const std::string& english) { return translated(english).toStdString(); });
    const std::function<void()> missed = callbacks.missed;
    mouse_ = std::make_unique<MouseTool>(*scene_, std::move(callbacks));
    keys_ = std::make_unique<KeyTool>(
        *scene_, *mouse_,
        [this] {
            const QSize size = pixel_size(this->size(), devicePixelRatioF());
            return Pixel{static_cast<double>(size.width()), static_cast<double>(size.height())};
        },
        missed);
    canvas_ = make_canvas(*this, painter());
    canvas_->widget().setAttribute(Qt::WA_TransparentForMouseEvents);
    canvas_->widget().setFocusPolicy(Qt::NoFocus);
    focus_ = new ViewFocus(*this);
    setProperty(paints_own_focus, true);
    setAccessibleName(Words::tr("The vessels in three dimensions"));
    rest_timer_.setSingleShot(true);
    rest_timer_.setInterval(200);
    connect(&rest_timer_, &QTimer::timeout, this, [this] {
        scene_->set_moving(false);
        if (software()) scene_->set_smoothing(Smoothing::cheap);
        canvas_->redraw();
    });
    soon_timer_.setSingleShot(true);
    soon_timer_.setInterval(50);
    connect(&soon_timer_, &QTimer::timeout, this, [this] { draw_again(); });
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
}

// The base class destroys the canvas later, when the painter's members are gone.
VtkWidget::~VtkWidget() {
    canvas_->finish();
}

void VtkWidget::make_current() {
    if (canvas_ != nullptr) canvas_->make_current();
}

CanvasPainter VtkWidget::painter() {
    return {.begin = [this](QOpenGLContext& context) { begin(context); },
            .draw = [this](const QSize& pixels) { return draw(pixels); },
            .shown = [this] { picture_shown(); },
            .end =
                [this] {
                    window_->SetIsCurrent(true);
                    window_->Finalize();
                }};
}

void VtkWidget::begin(QOpenGLContext& context) {
    window_->SetReadyForRendering(true);
    window_->SetIsCurrent(true);
    window_->SetOwnContext(0);
    window_->InitializeFromCurrentContext();
    const auto* name = context.functions()->glGetString(GL_RENDERER);
    renderer_name_ = name ? reinterpret_cast<const char*>(name) : "";
    scene_->set_smoothing(software() ? Smoothing::cheap : Smoothing::best);
}

bool VtkWidget::software() const {
    return is_software_renderer(renderer_name_);
}

void VtkWidget::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // At once, so that a click before the next picture uses the new size.
    const QSize size = pixel_size(this->size(), devicePixelRatioF());
    window_->SetSize(size.width(), size.height());
    canvas_->widget().setGeometry(rect());
    focus_->setGeometry(rect());
    if (focus_->aim()) show_aim();
}

unsigned VtkWidget::draw(const QSize& pixels) {
    since_painting_.start();
    mouse_->set_click_radius(4.0 * devicePixelRatioF());
    keys_->set_step(6.0 * devicePixelRatioF());
    window_->SetIsCurrent(true);
    window_->GetState()->Reset();
    window_->GetState()->Push();
    window_->SetFrameBlitModeToNoBlit();
    window_->SetSize(pixels.width(), pixels.height());
    scene_->render(devicePixelRatioF());
    window_->GetState()->Pop();
    submitted_ms_ = 1e-6 * static_cast<double>(since_painting_.nsecsElapsed());
    return window_->GetDisplayFramebuffer()->GetFBOIndex();
}

void VtkWidget::picture_shown() {
    last_.on_screen_ms = 1e-6 * static_cast<double>(since_painting_.nsecsElapsed());
    // With a graphics card the rest of the time is spent waiting for the screen.
    last_.processor_ms = software() ? last_.on_screen_ms : submitted_ms_;
    for (const auto& listener : on_picture_) listener(last_);
}

int VtkWidget::wait_before_picture_ms() const {
    constexpr double longest_ms = 45.0;
    if (!software() || !since_painting_.isValid()) return 0;
    const double period_ms = std::min(2.0 * last_.on_screen_ms, longest_ms);
    const double passed_ms = 1e-6 * static_cast<double>(since_painting_.nsecsElapsed());
    return std::max(0, static_cast<int>(std::lround(period_ms - passed_ms)));
}

void VtkWidget::show_frame(const Frame& frame) {
    if (scene_->show(frame)) draw_again();
    mouse_->hand().follow(frame.tool);
}

void VtkWidget::draw_again() {
    scene_->set_moving(true);
    if (software()) scene_->set_smoothing(Smoothing::none);
    rest_timer_.start();
    canvas_->redraw();
}

void VtkWidget::draw_soon() {
    constexpr qint64 longest_wait_ms = 200;
    if (!software()) return draw_again();
    if (!soon_timer_.isActive()) since_asked_.start();
    if (since_asked_.elapsed() < longest_wait_ms) soon_timer_.start();
}

QImage VtkWidget::picture() {
    scene_->set_smoothing(Smoothing::best);
    scene_->set_moving(false);
    const QImage picture = canvas_->drawn();
    if (software()) scene_->set_smoothing(Smoothing::cheap);
    scene_->set_moving(rest_timer_.isActive());
    return picture;
}

Pixel VtkWidget::pixel_of(const QPointF& point) const {
    return pixel_at(point, devicePixelRatioF());
}

void VtkWidget::let_go() {
    take_from_keys();
    mouse_->cancel();
}

void VtkWidget::take_from_keys() {
    keys_->let_go();
    focus_->show_aim(std::nullopt, false);
}

void VtkWidget::mode_chosen() {
    if (key_is_down_ && hasFocus()) show_aim();
}

void VtkWidget::show_aim() {
    const Pixel aim = keys_->aim();
    focus_->show_aim(point_at(aim, devicePixelRatioF()), keys_->leads());
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
    calm_.pressed();
    take_from_keys();
    mouse_->press(pixel_of(event->position()), button_of(*event), modifiers_of(*event));
    draw_again();
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton && calm_.swallows(event->timestamp())) return;
    // A mouse movement does not end a pull by keys; a tool follows the mouse again.
    if (keys_->leads() && mouse_->mode() != MouseMode::tool) return;
    if (mouse_->mode() == MouseMode::tool) take_from_keys();
    if (mouse_->move(pixel_of(event->position()))) draw_again();
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
    mouse_->release(pixel_of(event->position()));
    draw_again();
}

void VtkWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    const Pixel at = pixel_of(event->position());
    if (!mouse_->takes_double_click(at, button_of(*event), modifiers_of(*event)))
        return mousePressEvent(event);
    mouse_->double_click(at);
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
    if (calm_.swallows(event->timestamp())) return;
    // With Alt held, some systems report a horizontal wheel.
    const QPoint turned = event->angleDelta();
    mouse_->wheel((turned.y() != 0 ? turned.y() : turned.x()) / 120.0, modifiers_of(*event));
    draw_again();
}

void VtkWidget::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    if (hover_) hover_(SurfacePick{});
}

// Escape first lets go of what is held; otherwise the window's Escape puts a tool away.
bool VtkWidget::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) key_is_down_ = true;
    if (event->type() == QEvent::KeyRelease) key_is_down_ = false;
    if (event->type() == QEvent::ShortcutOverride && keys_->leads() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    return QWidget::event(event);
}

void VtkWidget::keyPressEvent(QKeyEvent* event) {
    const std::optional<ViewKey> key = view_key_of(*event);
    if (key && *key != ViewKey::enter && calm_.swallows(event->timestamp())) return;
    const MouseModifiers modifiers = modifiers_of(*event);
    const bool enter = key == ViewKey::enter;
    // Ctrl + Enter is the only key with Ctrl.
    if (!key || modifiers.alt || (modifiers.control && !enter) ||
        (enter && event->isAutoRepeat()) || !keys_->press(*key, modifiers))
        return QWidget::keyPressEvent(event);
    const bool turned = !keys_->leads() && !enter && !modifiers.shift;
    // Highlights what is there.
    if (turned && mouse_->mode() != MouseMode::tool) mouse_->move(keys_->aim());
    show_aim();
    draw_again();
}

void VtkWidget::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    focus_->setGeometry(rect());
    focus_->show();
    focus_->raise();
    const bool by_key =
        event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    if (by_key) show_aim();
}

void VtkWidget::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    key_is_down_ = false;
    take_from_keys();
    focus_->hide();
    mouse_->cancel();
}

}  // namespace hepatica
