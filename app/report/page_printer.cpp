// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page_printer.h"

#include <QAbstractTextDocumentLayout>
#include <QGuiApplication>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QScreen>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextFrame>
#include <QTextImageFormat>
#include <QTextLayout>
#include <QUrl>
#include <memory>
#include <vector>

#include "ui/paths.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// QTextDocument supports neither figures nor the units of the page's style sheet.
QString in_plain_html(QString html) {
    static const QRegularExpression style_sheet("<style>.*</style>",
                                                QRegularExpression::DotMatchesEverythingOption);
    html.remove(style_sheet);
    html.replace("<figure>", "<p>");
    html.replace("<figcaption>", "<br>");
    html.replace("</figcaption></figure>", "</p>");
    html.replace("<table>", "<table cellpadding=\"4\">");
    return html;
}

// Makes pictures as wide as the text on paper, and sets their heights: otherwise QTextDocument
// reserves the original height at any width.
void fit_pictures(QTextDocument& document, const fs::path& folder) {
    constexpr double width = 600.0;
    struct Place {
        int begin, end;
        QTextImageFormat format;
    };
    std::vector<Place> places;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const QTextFragment fragment = piece.fragment();
            if (fragment.charFormat().isImageFormat())
                places.push_back({fragment.position(), fragment.position() + fragment.length(),
                                  fragment.charFormat().toImageFormat()});
        }
    QTextCursor cursor(&document);
    for (Place& place : places) {
        const QImage picture(to_text(folder / to_path(place.format.name())));
        place.format.setWidth(width);
        place.format.setHeight(width * picture.height() / picture.width());
        cursor.setPosition(place.begin);
        cursor.setPosition(place.end, QTextCursor::KeepAnchor);
        cursor.setCharFormat(place.format);
    }
}

bool holds_picture(const QTextBlock& block) {
    for (auto piece = block.begin(); !piece.atEnd(); ++piece)
        if (piece.fragment().charFormat().isImageFormat()) return true;
    return false;
}

// The block that must be on a heading's page: the next one, or the picture after a single line of
// text.
QTextBlock what_follows(const QTextBlock& heading) {
    const QTextBlock next = heading.next(), after = next.next();
    return after.isValid() && !holds_picture(next) && holds_picture(after) ? after : next;
}

// The first heading separated from what follows by a page break, in the layout of
// QTextDocument::print(); -1: none.
int lonely_heading(const QTextDocument& document, QPdfWriter& writer) {
    // print() uses margins of 2 cm in screen dots, which the layout scales to the paper.
    constexpr double margin_inch = 2.0 / 2.54;
    const double screen_dots = QGuiApplication::primaryScreen()->logicalDotsPerInchY();
    const std::unique_ptr<QTextDocument> laid_out(document.clone());
    laid_out->documentLayout()->setPaintDevice(&writer);
    QTextFrameFormat format = laid_out->rootFrame()->frameFormat();
    format.setMargin(static_cast<int>(margin_inch * screen_dots));
    laid_out->rootFrame()->setFrameFormat(format);
    const double page = writer.height();
    laid_out->setPageSize(QSizeF(writer.width(), page));
    const auto page_of = [&](const QTextBlock& block) {
        const double top = laid_out->documentLayout()->blockBoundingRect(block).top();
        const QTextLayout& lines = *block.layout();
        const double first_line = lines.lineCount() > 0 ? lines.lineAt(0).y() : 0.0;
        return static_cast<int>((top + first_line) / page);
    };
    for (QTextBlock block = laid_out->begin(); block.isValid(); block = block.next()) {
        const QTextBlock next = what_follows(block);
        if (block.blockFormat().headingLevel() > 0 && next.isValid() &&
            page_of(block) != page_of(next))
            return block.blockNumber();
    }
    return -1;
}

void keep_headings_with_what_follows(QTextDocument& document, QPdfWriter& writer) {
    for (int tries = document.blockCount(); tries > 0; --tries) {
        const int lonely = lonely_heading(document, writer);
        if (lonely < 0) return;
        QTextCursor cursor(document.findBlockByNumber(lonely));
        QTextBlockFormat format;
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        cursor.mergeBlockFormat(format);
    }
}

}  // namespace

void print_pdf(const std::string& html, const fs::path& folder, const fs::path& file) {
    QTextDocument document;
    document.setBaseUrl(QUrl::fromLocalFile(to_text(folder) + "/"));
    document.setMetaInformation(QTextDocument::DocumentUrl,
                                QUrl::fromLocalFile(to_text(folder) + "/").toString());
    document.setHtml(in_plain_html(QString::fromStdString(html)));
    fit_pictures(document, folder);
    QPdfWriter writer(to_text(file));
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setResolution(150);
    writer.setTitle("Hepatica");
    keep_headings_with_what_follows(document, writer);
    document.print(&writer);
}

}  // namespace hepatica
