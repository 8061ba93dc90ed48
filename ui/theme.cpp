// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include <QApplication>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>

namespace hepatica {
namespace {

const char* const rules = R"(
QToolTip { color: #e3e6ea; background: #2a323d; border: 1px solid #465160; padding: 4px; }
QMainWindow::separator { background: #14181e; width: 4px; height: 4px; }
QToolBar { background: #1d232b; border: none; spacing: 4px; padding: 4px; }
QToolBar QToolButton { padding: 5px 10px; border-radius: 4px; }
QToolBar QToolButton:hover { background: #2c3541; }
QToolBar QToolButton:checked { background: #3c6aa8; color: white; }
QStatusBar { background: #1a1f26; color: #aab3bf; }
QStatusBar::item { border: none; }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: #1d232b; padding: 7px 10px; }
QGroupBox { border: 1px solid #2f3843; border-radius: 6px; margin-top: 16px; padding: 6px; }
QGroupBox::title { subcontrol-origin: margin; left: 8px; color: #aab3bf; }
QPushButton { padding: 5px 12px; border-radius: 4px; background: #2c3541; border: 1px solid #3a4552; }
QPushButton:hover { background: #35404e; }
QPushButton:disabled { color: #68717d; background: #22282f; }
QPushButton:default { background: #3c6aa8; border-color: #4f7dbb; color: white; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid #566270; border-radius: 3px;
    background: #181d24; }
QCheckBox::indicator:checked { background: #4f8fd6; border-color: #7db3f0; }
QProgressBar { border: none; border-radius: 3px; background: #262d36; height: 8px; }
QProgressBar::chunk { background: #4f8fd6; border-radius: 3px; }
QFrame#messageBar { background: #5a2b2b; }
QFrame#messageBar[kind="notice"] { background: #3a3f2a; }
QFrame#messageBar QLabel { color: #f2e9e6; }
QFrame#progressStrip { background: #1d232b; }
QFrame#welcome { background: rgba(24, 29, 36, 235); border: 1px solid #36404c; border-radius: 12px; }
QLabel#welcomeTitle { font-size: 22px; font-weight: 600; color: #eef1f4; }
QLabel#quiet { color: #97a1ad; }
)";

// Fusion, but a click on a slider's groove takes the handle there instead of a page nearer.
class Style : public QProxyStyle {
  public:
    Style() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
};

}  // namespace

void apply_theme(QApplication& application) {
    application.setStyle(new Style);
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(0x20, 0x26, 0x2e));
    palette.setColor(QPalette::WindowText, QColor(0xde, 0xe2, 0xe7));
    palette.setColor(QPalette::Base, QColor(0x18, 0x1d, 0x24));
    palette.setColor(QPalette::AlternateBase, QColor(0x1e, 0x24, 0x2c));
    palette.setColor(QPalette::Text, QColor(0xde, 0xe2, 0xe7));
    palette.setColor(QPalette::PlaceholderText, QColor(0x7c, 0x86, 0x92));
    palette.setColor(QPalette::Button, QColor(0x2c, 0x35, 0x41));
    palette.setColor(QPalette::ButtonText, QColor(0xde, 0xe2, 0xe7));
    palette.setColor(QPalette::Highlight, QColor(0x3c, 0x6a, 0xa8));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x7d, 0xb3, 0xf0));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(0x68, 0x71, 0x7d));
    }
    application.setPalette(palette);
    application.setStyleSheet(rules);
}

}  // namespace hepatica
