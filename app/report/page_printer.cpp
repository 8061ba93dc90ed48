// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page_printer.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QGuiApplication>
#include <QImageReader>
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
#include <algorithm>
#include <memory>
#include <utility>
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

// Widths of pictures, in dots of the screen; the widest are as wide as the text.
constexpr double widest_picture = 600.0, narrowest_picture = 340.0, narrower_by = 20.0;

// A curve over time, which is as wide as the text on every page.
bool is_flat(const QSize& picture) {
    return picture.width() > 2 * picture.height();
}

// Sets the pictures' widths and heights: without the latter QTextDocument reserves the original
// height at any width.
void fit_pictures(QTextDocument& document, const fs::path& folder, double width) {
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
        const QSize picture = QImageReader(to_text(folder / to_path(place.format.name()))).size();
        if (picture.isEmpty()) continue;
        const double own = is_flat(picture) ? widest_picture : width;
        place.format.setWidth(own);
        place.format.setHeight(own * picture.height() / picture.width());
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
        : laid_out_(document.clone()),
          page_(writer.height()),
          margin_(margin_inch * writer.logicalDpiY()) {
        // print() uses margins of 2 cm in screen dots, which the layout scales to the paper.
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
    // The largest share of a page that is white below what stands on it; the last page's does not
    // count.
    double largest_white() const {
        std::vector<double> foot;  // of what stands on each page, from its top
        for (QTextBlock block = begin(); block.isValid(); block = block.next()) {
            const double top = laid_out_->documentLayout()->blockBoundingRect(block).top();
            for (int line = 0; line < block.layout()->lineCount(); ++line) {
                const auto page = static_cast<std::size_t>(page_of_line(block, line));
                const QTextLine drawn = block.layout()->lineAt(line);
                foot.resize(std::max(foot.size(), page + 1), margin_);
                const double below = top + drawn.y() + drawn.height();
                foot[page] = std::max(foot[page], below - static_cast<double>(page) * page_);
            }
        }
        if (!foot.empty()) foot.pop_back();
        double white = 0.0;
        for (const double below : foot) white = std::max(white, page_ - margin_ - below);
        return white / (page_ - 2.0 * margin_);
    }

  private:
    static constexpr double margin_inch = 2.0 / 2.54;

    int page_of_line(const QTextBlock& block, int line) const {
        const double top = laid_out_->documentLayout()->blockBoundingRect(block).top();
        const QTextLayout& lines = *block.layout();
        const double from_top =
            line >= 0 && line < lines.lineCount() ? lines.lineAt(line).y() : 0.0;
        return static_cast<int>((top + from_top) / page_);
    }

    std::unique_ptr<QTextDocument> laid_out_;
    double page_, margin_;
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

std::unique_ptr<QTextDocument> read_page(const std::string& html, const fs::path& folder,
                                         double width) {
    auto document = std::make_unique<QTextDocument>();
    document->setBaseUrl(QUrl::fromLocalFile(to_text(folder) + "/"));
    document->setMetaInformation(QTextDocument::DocumentUrl,
                                 QUrl::fromLocalFile(to_text(folder) + "/").toString());
    document->setHtml(in_plain_html(QString::fromStdString(html)));
    fit_pictures(*document, folder, width);
    return document;
}

// The page with pictures as wide as leaves hardly any page half empty: one that does not fit below
// what stands before it goes to the next. All have one width, so that they can be compared.
std::unique_ptr<QTextDocument> in_pages(const std::string& html, const fs::path& folder,
                                        QPdfWriter& writer) {
    constexpr double little = 0.2;  // of a page
    std::unique_ptr<QTextDocument> best;
    double least = 1.0;
    for (double width = widest_picture; width >= narrowest_picture && (!best || least > little);
         width -= narrower_by) {
        auto document = read_page(html, folder, width);
        keep_together(*document, writer);
        const double white = OnPaper(*document, writer).largest_white();
        if (best && white >= least) continue;
        best = std::move(document);
        least = white;
    }
    return best;
}

void set_up(QPdfWriter& writer) {
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setResolution(150);
    writer.setTitle("Hepatica");
}

}  // namespace

void print_pdf(const std::string& html, const fs::path& folder, const fs::path& file) {
    // In memory, because the writer does not say whether the disk took what it wrote.
    QBuffer made;
    made.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&made);
        set_up(writer);
        in_pages(html, folder, writer)->print(&writer);
    }
    write_text_atomically(file, made.data().toStdString());
}

PrintedPages printed_pages(const std::string& html, const fs::path& folder) {
    QBuffer nowhere;
    nowhere.open(QIODevice::WriteOnly);
    QPdfWriter writer(&nowhere);
    set_up(writer);
    const auto document = in_pages(html, folder, writer);
    const OnPaper paper(*document, writer);
    PrintedPages pages;
    for (QTextBlock block = paper.begin(); block.isValid(); block = block.next())
        if (holds_picture(block))
            pages.pictures.push_back({paper.first_page_of(block), paper.last_page_of(block)});
    pages.largest_white = paper.largest_white();
    return pages;
}

}  // namespace hepatica
