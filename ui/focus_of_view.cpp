// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/focus_of_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabBar>

namespace hepatica {
namespace {

// By its tab: QDockWidget::raise() does nothing where Qt's frame of focus puts itself above the
// dock meanwhile, as it does for a control that fills one.
void bring_to_front(const QDockWidget& dock) {
    for (QTabBar* tabs : dock.parentWidget()->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        for (int tab = 0; tab < tabs->count(); ++tab)
            if (tabs->tabText(tab) == dock.windowTitle()) tabs->setCurrentIndex(tab);
}

// What the mouse presses is in sight; if it moved away, it would not be clicked.
void bring_into_sight(QWidget* focused, const QWidget& window) {
    const bool pressed = QApplication::mouseButtons() != Qt::NoButton;
    for (QWidget* up = focused; up != nullptr && up != &window; up = up->parentWidget()) {
        auto* scroll = qobject_cast<QScrollArea*>(up);
        if (scroll && !pressed) scroll->ensureWidgetVisible(focused);
        const auto* dock = qobject_cast<QDockWidget*>(up);
        if (dock && dock->visibleRegion().isEmpty()) bring_to_front(*dock);
    }
}

// Qt keeps the bar of panels that are no longer one behind the other, beyond the window's edge.
void let_only_tabs_in_sight_take_focus(const QMainWindow& window) {
    for (QTabBar* tabs : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        tabs->setFocusPolicy(tabs->visibleRegion().isEmpty() ? Qt::NoFocus : Qt::TabFocus);
}

bool is_behind_another(const QWidget& control) {
    for (const QWidget* up = &control; up != nullptr && !up->isWindow(); up = up->parentWidget())
        if (qobject_cast<const QDockWidget*>(up) != nullptr) return up->visibleRegion().isEmpty();
    return false;
}

// As Qt decides it, for the window's own order of Tab.
bool takes_tab(const QWidget& control, const QWidget& window) {
    return (control.focusPolicy() & Qt::TabFocus) == Qt::TabFocus &&
           control.focusProxy() == nullptr && control.isEnabled() && control.isVisibleTo(&window) &&
           control.window() == &window && !is_behind_another(control);
}

}  // namespace

void give_focus_back_to(QWidget& view) {
    QObject::connect(qApp, &QApplication::focusChanged, &view,
                     [&view](const QWidget* before, const QWidget* now) {
                         if (before == nullptr || now == nullptr || now == &view) return;
                         const QWidget* window = view.window();
                         if (before->window() != window || now->window() != window) return;
                         if (!before->isEnabled() || !before->isVisible()) view.setFocus();
                     });
}

void keep_focus_in_sight(QMainWindow& window, QWidget& view) {
    QObject::connect(
        qApp, &QApplication::focusChanged, &window,
        [&window, &view](QWidget* before, QWidget* now) {
            let_only_tabs_in_sight_take_focus(window);
            // The view may have taken it already, see give_focus_back_to().
            if (now == nullptr || now != QApplication::focusWidget()) return;
            // It came with the window, as after a dialog whose button is hidden now.
            if (before == nullptr && window.isAncestorOf(now) && is_behind_another(*now))
                return view.setFocus();
            bring_into_sight(now, window);
        });
    for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        QObject::connect(dock, &QDockWidget::visibilityChanged, &view, [dock, &view] {
            const QWidget* focused = QApplication::focusWidget();
            if (focused && dock->isAncestorOf(focused) && dock->visibleRegion().isEmpty())
                view.setFocus();
        });
}

bool focus_next_in_sight(QMainWindow& window, bool next) {
    QWidget* from = window.focusWidget() != nullptr ? window.focusWidget() : &window;
    const auto after = [next](QWidget* control) {
        return next ? control->nextInFocusChain() : control->previousInFocusChain();
    };
    for (QWidget* control = after(from); control != from; control = after(control)) {
        if (!takes_tab(*control, window)) continue;
        window.activateWindow();
        control->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
        return true;
    }
    return false;
}

}  // namespace hepatica
