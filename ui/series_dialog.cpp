// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/series_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/core_words.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/series_thumbnails.h"
#include "ui/untinted_icon.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QTreeWidgetItem* row_of(const SeriesDescription& series, int number) {
    const QString spacing = series.spacing_mm > 0.0
                                ? QString("%L1 mm").arg(series.spacing_mm, 0, 'g', 3)
                                : Words::tr("unknown");
    const QString why = series.why_not_chosen.empty()
                            ? Words::tr("the best for the liver's vessels")
                            : why_not_first(series);
    // DICOM separates several values of a field by backslashes.
    const QString kernel = QString::fromStdString(series.kernel).replace("\\", ", ");
    const auto warnings = series.warnings.size();
    return new QTreeWidgetItem({QString::number(number), name_in_list(series),
                                QString::number(series.slices), spacing, kernel,
                                translated(series.phase),
                                warnings > 0 ? QString::number(warnings) : QString(), why});
}

constexpr int picture_points = 96;

// Placeholder for a picture that is not there yet, or missing.
QPixmap placeholder(double pixels_per_point, const QString& text) {
    const int side = static_cast<int>(std::ceil(picture_points * pixels_per_point));
    QPixmap empty(side, side);
    empty.setDevicePixelRatio(pixels_per_point);
    empty.fill(QColor(45, 48, 54));
    QPainter painter(&empty);
    painter.setPen(QColor(150, 156, 166));
    painter.drawText(QRect(0, 0, picture_points, picture_points),
                     Qt::AlignCenter | Qt::TextWordWrap, text);
    return empty;
}

// A focus frame would cover the pictures; the selected row shows where the focus is.
class WithoutFocusFrame : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->state &= ~QStyle::State_HasFocus;
    }
};

}  // namespace

QString name_in_list(const SeriesDescription& series) {
    QString name = QString::fromStdString(series.description);
    if (name.startsWith("series")) name = name.mid(6).trimmed();  // prefix added by core
    return name.isEmpty() ? Words::tr("unnamed") : name;
}

QString why_not_first(const SeriesDescription& series) {
    if (series.why_not_chosen.empty()) return {};
    return Words::tr("the first is better: %1").arg(translated(series.why_not_chosen));
}

SeriesDialog::SeriesDialog(const std::vector<SeriesDescription>& series, QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget(this)), warnings_(new QLabel(this)) {
    setWindowTitle(Words::tr("Choose a series"));
    setMinimumSize(760, 280);
    resize_on_screen(*this, {960, 460});
    auto* column = new QVBoxLayout(this);
    column->addWidget(
        new QLabel(Words::tr("The folder holds several CT series. Which one is to be read?")));
    list_->setObjectName("series");
    list_->setRootIsDecorated(false);
    list_->setItemDelegate(new WithoutFocusFrame(list_));
    list_->setWordWrap(true);
    list_->setIconSize(QSize(picture_points, picture_points));
    list_->setHeaderLabels({"", Words::tr("Series"), Words::tr("Images"), Words::tr("Apart"),
                            Words::tr("Kernel"), Words::tr("Phase"), Words::tr("Warnings"),
                            Words::tr("Why")});
    for (const SeriesDescription& one : series)
        list_->addTopLevelItem(row_of(one, list_->topLevelItemCount() + 1));
    name_folders(series);
    begin_pictures(series);
    list_->header()->resizeSections(QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(true);
    for (const auto& [index, widest] : {std::pair{1, 240}, std::pair{4, 90}, std::pair{5, 110}})
        // Longer text is wrapped.
        list_->setColumnWidth(index, std::min(list_->columnWidth(index), widest));
    show_warnings_of(series);
    list_->setCurrentItem(list_->topLevelItem(0));
    connect(list_, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    column->addWidget(list_);
    column->addWidget(warnings_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(Words::tr("Open"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    list_->setFocus();
}

SeriesDialog::~SeriesDialog() = default;

namespace {

// Where they part: the innermost folder alone is often called alike ("DICOM") in all.
std::filesystem::path shared_folder(const std::vector<SeriesDescription>& series,
                                    const QString& name) {
    std::optional<std::filesystem::path> shared;
    for (const SeriesDescription& one : series) {
        const std::filesystem::path folder = one.middle_slice.parent_path();
        if (name_in_list(one) != name || folder.empty()) continue;
        if (!shared) {
            shared = folder;
            continue;
        }
        const auto parting = std::ranges::mismatch(*shared, folder);
        std::filesystem::path common;
        for (auto part = shared->begin(); part != parting.in1; ++part) common /= *part;
        shared = common;
    }
    return shared.value_or(std::filesystem::path());
}

}  // namespace

void SeriesDialog::name_folders(const std::vector<SeriesDescription>& series) {
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = list_->topLevelItem(row);
        const std::filesystem::path folder =
            series[static_cast<std::size_t>(row)].middle_slice.parent_path();
        const QString name = name_in_list(series[static_cast<std::size_t>(row)]);
        const auto called_so = std::ranges::count(series, name, name_in_list);
        if (folder.empty()) continue;
        item->setToolTip(1, as_plain(to_text(folder)));
        if (called_so < 2) continue;
        const std::filesystem::path apart = folder.lexically_relative(shared_folder(series, name));
        const bool same = apart.empty() || apart == ".";
        item->setText(1, name + "\n" + to_text(same ? folder.filename() : apart));
    }
}

// In full: a column would be cut off in a narrow window.
void SeriesDialog::show_warnings_of(const std::vector<SeriesDescription>& series) {
    warnings_->setObjectName("seriesWarnings");
    warnings_->setTextFormat(Qt::PlainText);
    warnings_->setWordWrap(true);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this, series](QTreeWidgetItem* item) {
        QStringList lines;
        const int row = list_->indexOfTopLevelItem(item);
        if (row >= 0)
            for (const std::string& warning : series[static_cast<std::size_t>(row)].warnings)
                lines << QString::fromUtf8("\u26A0 ") + translated(warning);
        warnings_->setText(lines.join("\n"));
        warnings_->setVisible(!lines.empty());
    });
}

void SeriesDialog::begin_pictures(const std::vector<SeriesDescription>& series) {
    std::vector<std::filesystem::path> slices;
    for (const SeriesDescription& one : series) {
        QTreeWidgetItem* row = list_->topLevelItem(static_cast<int>(slices.size()));
        row->setIcon(0, untinted(placeholder(devicePixelRatioF(), {})));
        slices.push_back(one.middle_slice);
    }
    const int side = static_cast<int>(std::ceil(picture_points * devicePixelRatioF()));
    thumbnails_ = std::make_unique<SeriesThumbnails>(
        std::move(slices), side, [this](std::size_t row, const QImage& picture) {
            show_picture(static_cast<int>(row), picture);
        });
    connect(this, &QDialog::finished, this, [this] { thumbnails_.reset(); });
}

void SeriesDialog::show_picture(int row, const QImage& picture) {
    QPixmap drawn = picture.isNull() ? placeholder(devicePixelRatioF(), Words::tr("no picture"))
                                     : QPixmap::fromImage(picture);
    drawn.setDevicePixelRatio(devicePixelRatioF());
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setIcon(0, untinted(drawn));
    item->setToolTip(0, picture.isNull()
                            ? Words::tr("The slice in the middle cannot be shown")
                            : Words::tr("The slice in the middle, in a window for soft "
                                        "tissue (L 40, W 400)"));
}

bool SeriesDialog::draws_pictures() const {
    return thumbnails_ && thumbnails_->working();
}

int SeriesDialog::chosen() const {
    return list_->indexOfTopLevelItem(list_->currentItem()) + 1;
}

}  // namespace hepatica
