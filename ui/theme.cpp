// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include <qdrawutil.h>
#include <QAbstractItemView>
#include <QApplication>
#include <QFocusFrame>
#include <QIcon>
#include <QPainter>
#include <QPalette>
#include <QPointF>
#include <QPointer>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace hepatica {
namespace {

// Names in braces are replaced by the theme's colours.
const char* const rules = R"(
QToolTip { color: {text}; background: {button}; border: 1px solid {frame}; padding: 4px; }
QMainWindow::separator { background: {frame}; width: 4px; height: 4px; }
QToolBar { background: {bar}; border: none; spacing: 4px; padding: 4px; }
QToolBar QToolButton { padding: 5px 8px; border-radius: 4px; }
QToolBar QToolButton#qt_toolbar_ext_button { padding: 0px; }
QToolBar QToolButton:hover { background: {button_hover}; }
QToolBar QToolButton:checked { background: {accent}; color: {accent_text}; }
QToolBar QToolButton:checked:disabled { background: {bar}; color: {disabled}; }
QStatusBar { background: {bar}; color: {quiet}; }
QStatusBar::item { border: none; }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: {bar}; padding: 7px 10px; }
QGroupBox { border: 1px solid {frame}; border-radius: 6px; margin-top: 16px; padding: 6px; }
QGroupBox::title { subcontrol-origin: margin; left: 8px; color: {quiet}; }
QPushButton { padding: 5px 12px; border-radius: 4px; background: {button}; border: 1px solid {frame}; }
QPushButton:hover { background: {button_hover}; }
QPushButton:focus { border-color: {accent_border}; }
QPushButton:disabled { color: {disabled}; background: {window}; }
QPushButton:default { background: {accent}; border-color: {accent_border}; color: {accent_text}; }
QPushButton#welcomeFirst { border-color: {accent_border}; font-weight: 600; }
QProgressBar { border: none; border-radius: 3px; background: {button}; height: 8px; }
QProgressBar::chunk { background: {accent_border}; border-radius: 3px; }
QFrame#messageBar { background: {failure}; }
QFrame#messageBar[kind="notice"] { background: {notice}; }
QFrame#messageBar QLabel { color: {message_text}; }
QFrame#progressStrip { background: {bar}; }
QFrame#welcome { background: {base}; border: 1px solid {frame}; border-radius: 12px; }
QLabel#welcomeTitle { font-size: 22px; font-weight: 600; color: {title}; }
QLabel#lessonStep { font-weight: 600; }
QLabel#quiet, QLabel#drugPace { color: {quiet}; }
QLabel#problem { color: {problem}; }
)";

QColor rgb(unsigned value) {
    return QColor::fromRgb(value);
}

// The curves' are those of Okabe and Ito that stand out on dark (sky blue, orange, purple, green),
// and the same hues darker or brighter on other grounds.
Theme dark() {
    return {.name = "dark",
            .window = rgb(0x20262e),
            .base = rgb(0x181d24),
            .bar = rgb(0x1c222a),
            .button = rgb(0x2c3541),
            .button_hover = rgb(0x35404e),
            .frame = rgb(0x3a4552),
            .text = rgb(0xdee2e7),
            .quiet = rgb(0xaab3bf),
            .disabled = rgb(0x68717d),
            .title = rgb(0xeef1f4),
            .accent = rgb(0x3c6aa8),
            .accent_border = rgb(0x4f8fd6),
            .accent_text = rgb(0xffffff),
            .link = rgb(0x7db3f0),
            .failure = rgb(0x5a2b2b),
            .notice = rgb(0x3a3f2a),
            .message_text = rgb(0xf2e9e6),
            .problem = rgb(0xf0a090),
            .view = dark_look,
            .plot = {{rgb(0x56b4e9), rgb(0xe69f00), rgb(0xcc79a7), rgb(0x009e73)},
                     rgb(0xff6b5e),
                     rgb(0xffc466)}};
}

Theme light() {
    return {.name = "light",
            .window = rgb(0xeef0f3),
            .base = rgb(0xffffff),
            .bar = rgb(0xe3e6eb),
            .button = rgb(0xfafbfc),
            .button_hover = rgb(0xdfe6f0),
            .frame = rgb(0xb4bcc7),
            .text = rgb(0x1c2128),
            .quiet = rgb(0x4c5663),
            .disabled = rgb(0x9099a5),
            .title = rgb(0x11151a),
            .accent = rgb(0x2f66b0),
            .accent_border = rgb(0x3f7ccb),
            .accent_text = rgb(0xffffff),
            .link = rgb(0x1d56a5),
            .failure = rgb(0xf6d3cf),
            .notice = rgb(0xf1eccb),
            .message_text = rgb(0x2a1d14),
            .problem = rgb(0xa32213),
            .view = light_look,
            .plot = {{rgb(0x0068a3), rgb(0xa34a00), rgb(0x9b3f78), rgb(0x007352)},
                     rgb(0xb3261a),
                     rgb(0x735600)}};
}

Theme high_contrast() {
    return {.name = "high-contrast",
            .window = rgb(0x000000),
            .base = rgb(0x1c1c1c),
            .bar = rgb(0x000000),
            .button = rgb(0x4a4a4a),
            .button_hover = rgb(0x3a3a3a),
            .frame = rgb(0xffffff),
            .text = rgb(0xffffff),
            .quiet = rgb(0xffffff),
            .disabled = rgb(0xa8a8a8),
            .title = rgb(0xffffff),
            .accent = rgb(0xffe100),
            .accent_border = rgb(0xffe100),
            .accent_text = rgb(0x000000),
            .link = rgb(0x7fd4ff),
            .failure = rgb(0x5c0000),
            .notice = rgb(0x2b2b00),
            .message_text = rgb(0xffffff),
            .problem = rgb(0xff9a8a),
            .view = high_contrast_look,
            .plot = {{rgb(0x7fd4ff), rgb(0xffb733), rgb(0xf09ccb), rgb(0x33d69f)},
                     rgb(0xff9a8a),
                     rgb(0xffe100)}};
}

const std::array<Theme, 3>& all_themes() {
    static const std::array<Theme, 3> all{dark(), light(), high_contrast()};
    return all;
}

QString style_sheet(const Theme& theme) {
    QString sheet = rules;
    const std::array<std::pair<const char*, QColor>, 18> colours{
        {{"window", theme.window},
         {"base", theme.base},
         {"bar", theme.bar},
         {"button", theme.button},
         {"button_hover", theme.button_hover},
         {"frame", theme.frame},
         {"text", theme.text},
         {"quiet", theme.quiet},
         {"disabled", theme.disabled},
         {"title", theme.title},
         {"accent", theme.accent},
         {"accent_border", theme.accent_border},
         {"accent_text", theme.accent_text},
         {"link", theme.link},
         {"failure", theme.failure},
         {"notice", theme.notice},
         {"message_text", theme.message_text},
         {"problem", theme.problem}}};
    for (const auto& [name, colour] : colours)
        sheet.replace(QString("{%1}").arg(name), colour.name());
    return sheet;
}

QPalette palette_of(const Theme& theme) {
    QPalette palette;
    palette.setColor(QPalette::Window, theme.window);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, theme.base);
    palette.setColor(QPalette::AlternateBase, theme.bar);
    palette.setColor(QPalette::Text, theme.text);
    // Readable like text, but distinct from it.
    palette.setColor(QPalette::PlaceholderText,
                     theme.quiet == theme.text ? theme.disabled : theme.quiet);
    palette.setColor(QPalette::Button, theme.button);
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::Highlight, theme.accent);
    palette.setColor(QPalette::HighlightedText, theme.accent_text);
    palette.setColor(QPalette::Link, theme.link);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, theme.disabled);
    return palette;
}

// Fusion with these changes: a click on a slider's groove moves the handle there, disabled text is
// not etched, check boxes have a tick visible in all themes, and the focused widget has a frame
// (FocusRing).
class Style : public QProxyStyle {
  public:
    explicit Style(const Theme& theme)
        : QProxyStyle(QStyleFactory::create("Fusion")), theme_(theme) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
        if (hint == SH_EtchDisabledText) return 0;
        // These icons suit one theme only: a black cross on a dark button.
        if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
        if (hint == SH_FocusFrame_AboveWidget) return 1;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override {
        // Rows of tables and lists, and combo boxes, take it for the room beside their text.
        if (metric == PM_FocusFrameHMargin && qobject_cast<const QAbstractItemView*>(widget))
            return beside_text_px;
        if (metric == PM_FocusFrameHMargin &&
            qstyleoption_cast<const QStyleOptionComboBox*>(option))
            return 1;
        if (metric == PM_FocusFrameHMargin || metric == PM_FocusFrameVMargin) return ring_px;
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        if (element != CE_FocusFrame) QProxyStyle::drawControl(element, option, painter, widget);
        if (element == CE_TabBarTabShape) mark_chosen_tab(*option, *painter);
        if (element != CE_FocusFrame) return;
        qDrawPlainRect(painter, option->rect, theme_.accent_border, ring_px);
    }
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        // FocusRing draws the frame, except for rows of lists.
        if (element == PE_FrameFocusRect && !qobject_cast<const QAbstractItemView*>(widget)) return;
        if (element != PE_IndicatorCheckBox)
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
        draw_check_box(*option, *painter);
    }

    // Fusion's own close buttons of docks, and arrows behind the last tool that a bar has room for,
    // are dark in every theme.
    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override {
        if (which == SP_ToolBarHorizontalExtensionButton)
            return drawn({{{0.2, 0.25}, {0.45, 0.5}, {0.2, 0.75}},
                          {{0.55, 0.25}, {0.8, 0.5}, {0.55, 0.75}}});
        if (which == SP_TitleBarCloseButton || which == SP_DockWidgetCloseButton)
            return drawn({{{0.25, 0.25}, {0.75, 0.75}}, {{0.25, 0.75}, {0.75, 0.25}}});
        return QProxyStyle::standardIcon(which, option, widget);
    }

  private:
    // All of the ring lies beside the widget, so that it shows on any of its colours and hides no
    // word.
    static constexpr int ring_px = 3, beside_text_px = 5;

    // Lines across a square with sides of 1, in the colour of text.
    QIcon drawn(const std::vector<std::vector<QPointF>>& lines) const {
        constexpr int side = 32;  // for screens with two pixels per point
        QPixmap picture(side, side);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(side, side);
        painter.setPen(QPen(theme_.text, 1.0 / 8.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        for (const std::vector<QPointF>& line : lines)
            painter.drawPolyline(line.data(), static_cast<int>(line.size()));
        return QIcon(picture);
    }

    // A bar, because a theme's shades may be too similar.
    void mark_chosen_tab(const QStyleOption& option, QPainter& painter) const {
        const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(&option);
        if (tab == nullptr || !(option.state & State_Selected)) return;
        const bool below = tab->shape == QTabBar::RoundedSouth;
        const QRect at = option.rect.adjusted(4, 0, -4, 0);
        painter.fillRect(QRect(at.left(), below ? at.bottom() - 3 : at.top() + 1, at.width(), 3),
                         theme_.accent_border);
    }

    void draw_check_box(const QStyleOption& option, QPainter& painter) const {
        const bool on = option.state & State_On, partly = option.state & State_NoChange;
        const bool enabled = option.state & State_Enabled;
        // In a selected row a box filled with another colour than the row's would look ticked.
        const bool chosen = option.state & State_Selected;
        const int side = std::min({option.rect.width(), option.rect.height(), 16});
        QRectF box(0, 0, side - 1, side - 1);
        box.moveCenter(QRectF(option.rect).center());
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(!enabled ? theme_.disabled
                            : chosen ? theme_.accent_text
                                     : theme_.quiet,
                            1.0));
        painter.setBrush((on && enabled) || chosen ? theme_.accent : theme_.base);
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(QPen(!enabled ? theme_.disabled
                            : on     ? theme_.accent_text
                                     : theme_.text,
                            2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const auto at = [&box](double x, double y) {
            return QPointF(box.x() + x * box.width(), box.y() + y * box.height());
        };
        if (on) painter.drawPolyline(QPolygonF{at(0.22, 0.52), at(0.42, 0.74), at(0.80, 0.28)});
        if (partly) painter.drawLine(at(0.25, 0.5), at(0.75, 0.5));
        painter.restore();
    }

    const Theme& theme_;
};

// Follows the focus through all windows, except for views that paint their own frame.
class FocusRing : public QObject {
  public:
    explicit FocusRing(QApplication& application) : QObject(&application) {
        setObjectName(name);
        connect(&application, &QApplication::focusChanged, this,
                [this](QWidget*, QWidget* now) { follow(now); });
        follow(QApplication::focusWidget());
    }
    ~FocusRing() override { delete frame_; }
    static constexpr const char* name = "focusRing";

  private:
    void follow(QWidget* now) {
        delete frame_;  // the next widget may be in another window
        if (now == nullptr || now->isWindow() || now->property(paints_own_focus).isValid()) return;
        if (now->window()->windowType() == Qt::Popup) return;  // such as the list of a combo box
        frame_ = new QFocusFrame(now);
        frame_->setWidget(now);
    }

    QPointer<QFocusFrame> frame_;
};

}  // namespace

std::span<const Theme> themes() {
    return all_themes();
}

const Theme& theme_named(const QString& name) {
    const auto found =
        std::ranges::find_if(themes(), [&](const Theme& theme) { return name == theme.name; });
    return found == themes().end() ? themes().front() : *found;
}

const PlotColours& plot_colours_on(const QColor& ground) {
    const auto nearest = std::ranges::min_element(themes(), {}, [&](const Theme& theme) {
        return std::abs(theme.base.lightness() - ground.lightness());
    });
    return nearest->plot;
}

void apply_theme(QApplication& application, const Theme& theme) {
    application.setStyle(new Style(theme_named(theme.name)));
    application.setPalette(palette_of(theme));
    application.setStyleSheet(style_sheet(theme));
    // Qt asks for this icon once.
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* more = qobject_cast<QToolButton*>(widget);
            more && more->objectName() == "qt_toolbar_ext_button")
            more->setIcon(
                application.style()->standardIcon(QStyle::SP_ToolBarHorizontalExtensionButton));
    delete application.findChild<QObject*>(FocusRing::name);
    new FocusRing(application);  // owned by the application
}

}  // namespace hepatica
