// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help_dialogs.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/actions.h"
#include "ui/guide.h"
#include "ui/mouse_scheme.h"
#include "ui/on_screen.h"
#include "ui/words.h"

namespace hepatica {

void show_guide(QWidget& parent) {
    auto* guide = parent.findChild<QDialog*>("guide");
    if (guide == nullptr) {
        guide = new Guide(&parent);
        guide->setAttribute(Qt::WA_DeleteOnClose);
    }
    guide->show();
    guide->raise();
    guide->activateWindow();
}

void show_cheat_sheet(QWidget& parent, const QString& mouse_scheme) {
    if (auto* shown = parent.findChild<QDialog*>("cheatSheet"); shown && shown->isVisible()) {
        shown->raise();
        return shown->activateWindow();
    }
    auto* sheet = new QDialog(&parent);
    sheet->setObjectName("cheatSheet");
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setWindowTitle(Words::tr("Keys and mouse"));
    resize_on_screen(*sheet, {620, 640});
    auto* text = new QTextBrowser(sheet);
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(Actions::cheat_sheet(mouse_scheme_named(mouse_scheme)));
    auto* column = new QVBoxLayout(sheet);
    column->addWidget(text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, sheet);
    QObject::connect(buttons, &QDialogButtonBox::rejected, sheet, &QDialog::reject);
    column->addWidget(buttons);
    sheet->show();
}

void show_about(QWidget& parent, const QString& renderer) {
    QMessageBox::about(
        &parent, Words::tr("About Hepatica"),
        Words::tr("<b>Hepatica %1</b><p>Practise on a patient's own liver vessels.</p>"
                  "<p>Renderer: %2</p>"
                  "<p>Licence: GPL-3.0-or-later. Not a medical device.</p>")
            .arg(HEPATICA_VERSION, renderer.toHtmlEscaped()));
}

}  // namespace hepatica
