// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/words.h"

namespace hepatica {

Welcome::Welcome(const Actions& actions, std::function<void()> lessons, QWidget* parent)
    : QFrame(parent) {
    setObjectName("welcome");
    auto* title = new QLabel("Hepatica", this);
    title->setObjectName("welcomeTitle");
    auto* hint =
        new QLabel(Words::tr("Practise on a patient's own liver vessels.\n"
                             "Drop a CT folder, a volume file or a case here, or begin with"),
                   this);
    hint->setObjectName("quiet");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(32, 26, 32, 28);
    column->setSpacing(12);
    column->addWidget(title);
    column->addWidget(hint);
    column->addSpacing(6);
    const auto add = [&](const QString& text, ActionId id) {
        auto* button = new QPushButton(text, this);
        button->setToolTip(actions[id].toolTip());
        connect(button, &QPushButton::clicked, &actions[id], &QAction::trigger);
        column->addWidget(button);
        return button;
    };
    add(Words::tr("The built-in patient"), ActionId::built_in)->setObjectName("welcomeFirst");
    auto* learn = new QPushButton(Words::tr("A lesson…"), this);
    learn->setObjectName("welcomeLessons");
    learn->setToolTip(Words::tr("The course, from the first lesson on, on the built-in patient"));
    connect(learn, &QPushButton::clicked, this, std::move(lessons));
    column->addWidget(learn);
    add(Words::tr("A CT folder (DICOM)…"), ActionId::open_ct_folder);
    add(Words::tr("A CT file (NIfTI, MetaImage, NRRD)…"), ActionId::open_ct_file);
    add(Words::tr("A case that was reconstructed before…"), ActionId::open_case);
    // So that the one that has the focus is lit, and that one alone.
    for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(true);
    parent->installEventFilter(this);
    centre();
}

bool Welcome::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) centre();
    return QFrame::eventFilter(watched, event);
}

void Welcome::centre() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2,
         std::max(covered_top_, (parentWidget()->height() - height()) / 2));
}

void Welcome::keep_clear(int top) {
    covered_top_ = top;
    centre();
}

}  // namespace hepatica
