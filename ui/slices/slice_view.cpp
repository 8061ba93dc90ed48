// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/tree/territories/segment_name.h"
#include "render/palette.h"
#include "ui/colours.h"
#include "ui/slices/slice_picture.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr double hu_per_point = 2.0;
constexpr double most_zoom = 20.0;

constexpr std::array names{Words::id("Axial"), Words::id("Coronal"), Words::id("Sagittal")};

QString title_of(SliceDirection direction) {
    return Words::tr(names[static_cast<std::size_t>(direction)]);
}

}  // namespace

SliceView::SliceView(SliceScene& scene, SliceDirection direction, QWidget* parent)
    : QWidget(parent), scene_(scene), direction_(direction) {
    setObjectName(names[static_cast<std::size_t>(direction)]);
    setAccessibleName(Words::tr("%1 slice").arg(title_of(direction)));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setProperty(paints_own_focus, true);
    setMinimumSize(120, 90);
    setCursor(Qt::CrossCursor);
    scene_.on_change([this] {
        show_whole_of_another_ct();
        update();
    });
    scene_.measurements().on_change([this] { update(); });
    scene_.pen().on_change([this] { update(); });
    scene_.seeds().on_change([this] { update(); });
}

// Where one looked into a CT means nothing in another.
void SliceView::show_whole_of_another_ct() {
    const std::shared_ptr<const Volume> seen = seen_ct_.lock();
    if (scene_.empty() || seen == scene_.shared_ct()) return;
    seen_ct_ = scene_.shared_ct();
    zoom_ = 1.0;
    shift_ = {};
}

int SliceView::slice() const {
    if (scene_.empty()) return -1;
    const double along = stack().place_of(scene_.crosshair_mm()).z();
    return std::clamp(static_cast<int>(std::lround(along)), 0, stack().count() - 1);
}

double SliceView::points_per_mm() const {
    const SliceStack slices = stack();
    const double wide_mm = slices.columns() * slices.column_mm();
    const double high_mm = slices.rows() * slices.row_mm();
    return zoom_ * std::min(width() / wide_mm, height() / high_mm);
}

QPointF SliceView::place_of(const Vec3& position_mm) const {
    const SliceStack slices = stack();
    const Vec3 place = slices.place_of(position_mm);
    const double scale = points_per_mm();
    return {0.5 * width() + shift_.x() +
                scale * slices.column_mm() * (place.x() - 0.5 * (slices.columns() - 1)),
            0.5 * height() + shift_.y() +
                scale * slices.row_mm() * (place.y() - 0.5 * (slices.rows() - 1))};
}

Vec3 SliceView::to_mm(const QPointF& place) const {
    const SliceStack slices = stack();
    const double scale = points_per_mm();
    const double column = 0.5 * (slices.columns() - 1) +
                          (place.x() - 0.5 * width() - shift_.x()) / (scale * slices.column_mm());
    const double row = 0.5 * (slices.rows() - 1) +
                       (place.y() - 0.5 * height() - shift_.y()) / (scale * slices.row_mm());
    return slices.to_mm(Vec3(column, row, slices.place_of(scene_.crosshair_mm()).z()));
}

const QImage& SliceView::picture() {
    if (scene_.empty()) {
        picture_ = {};
    } else if (picture_slice_ != slice() || picture_version_ != scene_.voxels_version()) {
        SlicePicture made = picture_of(scene_, stack(), slice());
        picture_ = std::move(made.image);
        segment_numbers_ = std::move(made.segment_numbers);
    }
    picture_slice_ = slice();
    picture_version_ = scene_.voxels_version();
    return picture_;
}

void SliceView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (scene_.empty()) return;
    const SliceStack slices = stack();
    const double scale = points_per_mm();
    const QSizeF size(scale * slices.columns() * slices.column_mm(),
                      scale * slices.rows() * slices.row_mm());
    const QPointF corner(0.5 * (width() - size.width()) + shift_.x(),
                         0.5 * (height() - size.height()) + shift_.y());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(corner, size), picture());
    painter.setRenderHint(QPainter::Antialiasing);
    paint_segment_numbers(painter);
    if (scene_.shows_centrelines()) paint_centrelines(painter);
    paint_pointed_out(painter);
    paint_crosshair(painter);
    paint_measurements(painter);
    paint_seeds(painter);
    paint_pen(painter);
    paint_brush(painter);
    paint_words(painter);
    if (hasFocus()) paint_focus(painter);
}

// Where segments lie close together, a number gives way within its own segment. Where it would get
// into another, the smaller segment's is left out: nearer, it has room.
void SliceView::paint_segment_numbers(QPainter& painter) {
    constexpr double spare = 1.0;  // for the outline
    number_labels_.clear();
    const SliceStack slices = stack();
    LabelPlaces places({0.0, 0.0, static_cast<double>(width()), static_cast<double>(height())});
    std::vector<SegmentNumber> largest_first = segment_numbers_;
    std::ranges::stable_sort(largest_first, std::ranges::greater(), &SegmentNumber::pixels);
    for (const SegmentNumber& number : largest_first) {
        const QPointF at = place_of(
            slices.to_mm(Vec3(number.pixel.x(), number.pixel.y(), static_cast<double>(slice()))));
        if (!rect().contains(at.toPoint())) continue;
        const QString text = QString::fromStdString(segment_name(number.segment));
        const double wide = painter.fontMetrics().horizontalAdvance(text) + 2.0 * spare;
        const double high = painter.fontMetrics().height() + 2.0 * spare;
        LabelPlaces with_it = places;
        const auto label = with_it.place({at.x() - 0.5 * wide, at.y() - 0.5 * high, wide, high});
        if (!label) continue;
        const QRectF box(label->box.left, label->box.top, wide, high);
        if (label->evades && scene_.segment_at(to_mm(box.center())) != number.segment) continue;
        places = with_it;
        write_outlined(painter, box, Qt::AlignCenter, text,
                       qcolor_of(colour_of_number(number.segment)));
        number_labels_.push_back({number.segment, box});
    }
}

void SliceView::paint_centrelines(QPainter& painter) const {
    const SliceStack slices = stack();
    const double half = std::max(0.5, 0.5 / slices.slice_mm());  // at least a millimetre in all
    const double here = slices.place_of(scene_.crosshair_mm()).z();
    std::map<VascularSystem, QPolygonF> dots;
    for (const CentrelinePoint& point : scene_.centrelines())
        if (std::abs(slices.place_of(point.position_mm).z() - here) <= half)
            dots[point.system] << place_of(point.position_mm);
    for (const auto& [system, places] : dots) {
        painter.setPen(QPen(qcolor_of(palette::vessel_system(system)).lighter(150), 3.6,
                            Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(places);
    }
}

// All of it faintly, because it runs through many slices, and clearly what lies in this one.
void SliceView::paint_pointed_out(QPainter& painter) const {
    const std::vector<Vec3>& path = scene_.pointed_out();
    const SliceStack slices = stack();
    const double half = std::max(0.5, 1.0 / slices.slice_mm());  // two millimetres in all
    const double here = slices.place_of(scene_.crosshair_mm()).z();
    const auto is_here = [&](const Vec3& point_mm) {
        return std::abs(slices.place_of(point_mm).z() - here) <= half;
    };
    for (std::size_t i = 1; i < path.size(); ++i) {
        QColor colour = qcolor_of(palette::bridge);
        const bool lies_here = is_here(path[i - 1]) && is_here(path[i]);
        colour.setAlphaF(lies_here ? 1.0f : 0.35f);
        painter.setPen(QPen(colour, lies_here ? 2.5 : 1.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(place_of(path[i - 1]), place_of(path[i]));
    }
}

void SliceView::paint_crosshair(QPainter& painter) const {
    constexpr double gap = 7.0;  // keeps the target visible
    const QPointF at = place_of(scene_.crosshair_mm());
    QColor colour = qcolor_of(palette::bridge);
    colour.setAlphaF(0.8f);
    painter.setPen(QPen(colour, 1.0));
    painter.drawLine(QPointF(0, at.y()), QPointF(at.x() - gap, at.y()));
    painter.drawLine(QPointF(at.x() + gap, at.y()), QPointF(width(), at.y()));
    painter.drawLine(QPointF(at.x(), 0), QPointF(at.x(), at.y() - gap));
    painter.drawLine(QPointF(at.x(), at.y() + gap), QPointF(at.x(), height()));
}

void SliceView::keep_clear(int top, int bottom) {
    covered_top_ = top;
    covered_bottom_ = bottom;
    update();
}

QRectF SliceView::room_for_words() const {
    return QRectF(rect()).adjusted(8, 6 + covered_top_, -8, -6 - covered_bottom_);
}

void SliceView::paint_words(QPainter& painter) const {
    const auto [left, right, top, bottom] = stack().edges();
    const QRectF inside = room_for_words();
    const auto write = [&](Qt::Alignment where, const QString& text) {
        write_outlined(painter, inside, where, text, qcolor_of(palette::text));
    };
    write(Qt::AlignLeft | Qt::AlignVCenter, QChar(left));
    write(Qt::AlignRight | Qt::AlignVCenter, QChar(right));
    write(Qt::AlignTop | Qt::AlignHCenter, QChar(top));
    write(Qt::AlignBottom | Qt::AlignHCenter, QChar(bottom));
    write(Qt::AlignTop | Qt::AlignLeft, title_of(direction_));
    write(Qt::AlignTop | Qt::AlignRight, QString("%1 / %2").arg(slice() + 1).arg(stack().count()));
    write(Qt::AlignBottom | Qt::AlignLeft, QString("L %1  W %2")
                                               .arg(scene_.window().level_hu, 0, 'f', 0)
                                               .arg(scene_.window().width_hu, 0, 'f', 0));
}

void SliceView::paint_focus(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    if (scene_.empty()) return;
    last_ = event->position();
    if (event->button() != Qt::LeftButton) return;
    crosshair_before_mm_ = scene_.crosshair_mm();
    if (measuring())
        measure(to_mm(last_));
    else if (drawing())
        set_place(to_mm(last_));
    else if (brushing())
        say(scene_.put_brush_down(to_mm(last_)));
    else if (seeding())
        scene_.seeds().add(to_mm(last_));
    else
        scene_.set_crosshair(to_mm(last_));
    if (scene_.corrects() && correct_) correct_(to_mm(last_));
}

// The other slices follow to where the vessel goes on.
void SliceView::set_place(const Vec3& position_mm) {
    scene_.set_crosshair(position_mm);
    scene_.pen().add(scene_.crosshair_mm());
}

void SliceView::say(const std::string& text) const {
    if (!text.empty() && say_) say_(QString::fromStdString(text));
}

void SliceView::measure(const Vec3& position_mm) {
    const SliceStack slices = stack();
    const Vec3 origin = slices.to_mm(Vec3::Zero());
    const SlicePlane plane{(slices.to_mm(Vec3::UnitZ()) - origin).normalized(),
                           (slices.to_mm(Vec3::UnitX()) - origin).normalized()};
    say(scene_.measurements().add_point(position_mm, plane, scene_.tree()));
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    if (scene_.empty()) return;
    const QPointF at = event->position();
    const QPointF moved = at - std::exchange(last_, at);
    if (brushing()) {
        mouse_ = at;
        update();
    }
    if (event->buttons() & Qt::LeftButton) {
        if (brushing()) scene_.lead_brush_to(to_mm(at));
        if (!works()) scene_.set_crosshair(to_mm(at));
    } else if (event->buttons() & Qt::RightButton) {
        const GreyWindow& window = scene_.window();
        scene_.set_window({window.level_hu + hu_per_point * moved.y(),
                           window.width_hu + hu_per_point * moved.x()});
    } else if (event->buttons() & Qt::MiddleButton) {
        shift_ += moved;
        update();
    }
    if (hover_) hover_(to_mm(at));
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) say(scene_.lift_brush());
    QWidget::mouseReleaseEvent(event);
}

void SliceView::leaveEvent(QEvent* event) {
    if (std::exchange(mouse_, std::nullopt)) update();
    QWidget::leaveEvent(event);
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (brushing()) return mousePressEvent(event);  // the next stroke begins
    if (works()) return;  // the second click must not set a point on top of the first
    if (event->button() != Qt::LeftButton || !double_click_) return;
    // The first click led the crosshair away, which was not meant.
    if (const auto before = std::exchange(crosshair_before_mm_, std::nullopt))
        scene_.set_crosshair(*before);
    double_click_();
}

void SliceView::wheelEvent(QWheelEvent* event) {
    if (scene_.empty()) return;
    // With Alt or Shift some systems report a horizontal wheel.
    const QPoint turned = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (event->modifiers() & Qt::ControlModifier) {
        const Vec3 kept = to_mm(event->position());
        zoom_ = std::clamp(zoom_ * std::pow(1.15, notches), 1.0, most_zoom);
        if (zoom_ == 1.0)
            shift_ = {};
        else
            shift_ += event->position() - place_of(kept);
        update();
        return;
    }
    wheel_rest_ += notches;
    const int whole = static_cast<int>(wheel_rest_);
    wheel_rest_ -= whole;
    step((event->modifiers() & Qt::ShiftModifier) ? 10 * whole : whole);
}

bool SliceView::sets_points_with(const QKeyEvent& event) const {
    // On many keyboards + needs Shift.
    const bool sizes = event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus;
    const Qt::KeyboardModifiers part_of_key =
        sizes ? Qt::KeypadModifier | Qt::ShiftModifier : Qt::KeypadModifier;
    if (event.modifiers() & ~part_of_key) return false;
    switch (event.key()) {
        case Qt::Key_Plus:
        case Qt::Key_Minus:
            return brushing();
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Escape:
            return works();
        // Accepted even if nothing is left to delete, so that one press too many does not remove
        // the drug or reset the play.
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return works() || !scene_.measurements().made().empty();
        default:
            return false;
    }
}

// Keys for measuring and drawing take precedence over the window's shortcuts.
bool SliceView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        sets_points_with(*static_cast<QKeyEvent*>(event)))
        event->accept();
    return QWidget::event(event);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    if (scene_.empty()) return QWidget::keyPressEvent(event);
    if (sets_points_with(*event))
        return scene_.corrects() ? correct_by_key(event->key())
               : brushing()      ? brush_by_key(event->key())
               : drawing()       ? draw_by_key(event->key())
               : seeding()       ? seed_by_key(event->key())
                                 : measure_by_key(event->key());
    switch (event->key()) {
        case Qt::Key_PageUp:
            return step(1);
        case Qt::Key_PageDown:
            return step(-1);
        case Qt::Key_Left:
            return nudge(-1, 0);
        case Qt::Key_Right:
            return nudge(1, 0);
        case Qt::Key_Up:
            return nudge(0, -1);
        case Qt::Key_Down:
            return nudge(0, 1);
        default:
            QWidget::keyPressEvent(event);
    }
}

void SliceView::measure_by_key(int key) {
    if (key == Qt::Key_Escape)
        scene_.measurements().choose(std::nullopt);
    else if (key == Qt::Key_Delete || key == Qt::Key_Backspace)
        scene_.measurements().remove_last();
    else
        measure(scene_.crosshair_mm());
}

void SliceView::correct_by_key(int key) {
    if (key == Qt::Key_Escape)
        scene_.set_corrects(false);
    else if (key != Qt::Key_Return && key != Qt::Key_Enter)
        scene_.measurements().remove_last();
    else if (correct_)
        correct_(scene_.crosshair_mm());
}

void SliceView::brush_by_key(int key) {
    if (key == Qt::Key_Escape)
        scene_.give_up_brush();
    else if (key == Qt::Key_Delete || key == Qt::Key_Backspace)
        scene_.take_last_stroke_back();
    else if (key == Qt::Key_Plus || key == Qt::Key_Minus)
        scene_.brush().resize(key == Qt::Key_Plus ? 1 : -1);
    else {
        say(scene_.put_brush_down(scene_.crosshair_mm()));
        say(scene_.lift_brush());
    }
}

void SliceView::seed_by_key(int key) {
    if (key == Qt::Key_Escape)
        scene_.seeds().take(std::nullopt);
    else if (key == Qt::Key_Delete || key == Qt::Key_Backspace)
        scene_.seeds().remove_last();
    else
        scene_.seeds().add(scene_.crosshair_mm());
}

void SliceView::draw_by_key(int key) {
    VesselPen& pen = scene_.pen();
    if (key == Qt::Key_Escape)
        pen.give_up();
    else if (key == Qt::Key_Delete || key == Qt::Key_Backspace)
        pen.remove_last();
    else if (!pen.places_mm().empty() && pen.places_mm().back() == scene_.crosshair_mm())
        pen.finish();
    else
        set_place(scene_.crosshair_mm());
}

void SliceView::step(int slices) {
    if (slices == 0) return;
    Vec3 place = stack().place_of(scene_.crosshair_mm());
    place.z() = slice() + slices;
    scene_.set_crosshair(stack().to_mm(place));
}

void SliceView::nudge(int columns, int rows) {
    const Vec3 place = stack().place_of(scene_.crosshair_mm());
    scene_.set_crosshair(stack().to_mm(place + Vec3(columns, rows, 0)));
}

}  // namespace hepatica
