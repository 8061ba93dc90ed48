// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page_printer.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
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

#include "core/base/atomic_write.h"
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

// A document laid out as QTextDocument::print() does it.
class OnPaper {
  public:
    OnPaper(const QTextDocument& document, QPdfWriter& writer)
        : laid_out_(document.clone()), page_(writer.height()) {
        // print() uses margins of 2 cm in screen dots, which the layout scales to the paper.
        constexpr double margin_inch = 2.0 / 2.54;
        const double screen_dots = QGuiApplication::primaryScreen()->logicalDotsPerInchY();
        laid_out_->documentLayout()->setPaintDevice(&writer);
        QTextFrameFormat format = laid_out_->rootFrame()->frameFormat();
        format.setMargin(static_cast<int>(margin_inch * screen_dots));
        laid_out_->rootFrame()->setFrameFormat(format);
        laid_out_->setPageSize(QSizeF(writer.width(), page_));
    }
    QTextBlock begin() const { return laid_out_->begin(); }
    int first_page_of(const QTextBlock& block) const { return page_of_line(block, 0); }
    int last_page_of(const QTextBlock& block) const {
        return page_of_line(block, block.layout()->lineCount() - 1);
    }

  private:
    int page_of_line(const QTextBlock& block, int line) const {
        const double top = laid_out_->documentLayout()->blockBoundingRect(block).top();
        const QTextLayout& lines = *block.layout();
        const double from_top =
            line >= 0 && line < lines.lineCount() ? lines.lineAt(line).y() : 0.0;
        return static_cast<int>((top + from_top) / page_);
    }

    std::unique_ptr<QTextDocument> laid_out_;
    double page_;
};

// The first block that is parted by the end of a page from what belongs to it: a heading, or a
// picture with its caption; -1: none.
int parted_block(const QTextDocument& document, QPdfWriter& writer) {
    const OnPaper paper(document, writer);
    for (QTextBlock block = paper.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore) continue;
        const QTextBlock next = what_follows(block);
        const bool lonely = block.blockFormat().headingLevel() > 0 && next.isValid() &&
                            paper.first_page_of(block) != paper.first_page_of(next);
        const bool cut =
            holds_picture(block) && paper.first_page_of(block) != paper.last_page_of(block);
        if (lonely || cut) return block.blockNumber();
    }
    return -1;
}

void keep_together(QTextDocument& document, QPdfWriter& writer) {
    for (int tries = document.blockCount(); tries > 0; --tries) {
        const int parted = parted_block(document, writer);
        if (parted < 0) return;
        QTextCursor cursor(document.findBlockByNumber(parted));
        QTextBlockFormat format;
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        cursor.mergeBlockFormat(format);
    }
}

}  // namespace

namespace {

void read_page(const std::string& html, const fs::path& folder, QTextDocument& document) {
    document.setBaseUrl(QUrl::fromLocalFile(to_text(folder) + "/"));
    document.setMetaInformation(QTextDocument::DocumentUrl,
                                QUrl::fromLocalFile(to_text(folder) + "/").toString());
    document.setHtml(in_plain_html(QString::fromStdString(html)));
    fit_pictures(document, folder);
}

void set_up(QPdfWriter& writer) {
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setResolution(150);
    writer.setTitle("Hepatica");
}

}  // namespace

void print_pdf(const std::string& html, const fs::path& folder, const fs::path& file) {
    QTextDocument document;
    read_page(html, folder, document);
    // In memory, because the writer does not say whether the disk took what it wrote.
    QBuffer made;
    made.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&made);
        set_up(writer);
        keep_together(document, writer);
        document.print(&writer);
    }
    write_text_atomically(file, made.data().toStdString());
}

std::vector<PicturePages> pages_of_pictures(const std::string& html, const fs::path& folder) {
    QTextDocument document;
    read_page(html, folder, document);
    QBuffer nowhere;
    nowhere.open(QIODevice::WriteOnly);
    QPdfWriter writer(&nowhere);
    set_up(writer);
    keep_together(document, writer);
    const OnPaper paper(document, writer);
    std::vector<PicturePages> pages;
    for (QTextBlock block = paper.begin(); block.isValid(); block = block.next())
        if (holds_picture(block))
            pages.push_back({paper.first_page_of(block), paper.last_page_of(block)});
    return pages;
}

}  // namespace hepatica
