// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a button with an object name to a row.
#pragma once

#include <QBoxLayout>
#include <QPushButton>
#include <functional>

namespace hepatica {

inline QPushButton* add_button(QBoxLayout& row, const QString& text, const char* name,
                               const std::function<void()>& run) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    QObject::connect(button, &QPushButton::clicked, button, [run] { run(); });
    row.addWidget(button);
    return button;
}

}  // namespace hepatica
