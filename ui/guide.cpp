// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>
#include <filesystem>
#include <system_error>

#include "core/base/program_files.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

namespace {

// The pages in the window's language if there are any, else the English ones.
QString folder_of_pages() {
    const std::filesystem::path english = asset("guide/index.md").parent_path();
    const std::filesystem::path translated =
        english / QLocale::languageToCode(QLocale().language()).toStdString();
    std::error_code ignored;
    return to_text(std::filesystem::exists(translated / "index.md", ignored) ? translated
                                                                             : english);
}

}  // namespace

Guide::Guide(QWidget* parent)
    : QDialog(parent), browser_(new QTextBrowser(this)), folder_(folder_of_pages()) {
    setWindowTitle(Words::tr("Guide"));
    setObjectName("guide");
    resize_on_screen(*this, {860, 740});
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setAccessibleName(Words::tr("Page of the guide"));
    auto* first = new QPushButton(Words::tr("First page"), this);
    auto* back = new QPushButton(Words::tr("Back"), this);
    back->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addWidget(first);
    row->addWidget(back);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(browser_, 1);
    connect(browser_, &QTextBrowser::sourceChanged, this, [this] { lay_out(); });
    connect(first, &QPushButton::clicked, this, [this] { show_page("index.md"); });
    connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    show_page("index.md");
    browser_->setFocus();
}

void Guide::show_page(const QString& name) {
    browser_->setSource(QUrl::fromLocalFile(folder_ + "/" + name), QTextDocument::MarkdownResource);
}

// Markdown has no layout: adds margins and line spacing and makes tables as wide as the page.
void Guide::lay_out() {
    QTextDocument& page = *browser_->document();
    page.setDocumentMargin(18);
    for (QTextFrame* frame : page.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
        format.setCellPadding(6);
        format.setCellSpacing(0);
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderBrush(browser_->palette().color(QPalette::Mid));
        table->setFormat(format);
    }
    QTextBlockFormat lines;
    lines.setLineHeight(130, QTextBlockFormat::ProportionalHeight);
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        // A picture sets its own height.
        if (!block.text().contains(QChar::ObjectReplacementCharacter))
            QTextCursor(block).mergeBlockFormat(lines);
}

}  // namespace hepatica
