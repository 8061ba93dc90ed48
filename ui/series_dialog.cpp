// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/series_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace hepatica {
namespace {

QTreeWidgetItem* row_of(const SeriesDescription& series, int number) {
    const QString spacing =
        series.spacing_mm > 0.0 ? QString("%1 mm").arg(series.spacing_mm, 0, 'g', 3) : "unknown";
    const QString why = series.why_not_chosen.empty()
                            ? "the best for the liver's vessels"
                            : "of the best, " + QString::fromStdString(series.why_not_chosen);
    return new QTreeWidgetItem({QString::number(number), QString::fromStdString(series.description),
                                QString::number(series.slices), spacing,
                                QString::fromStdString(series.kernel),
                                QString::fromStdString(series.phase), why});
}

}  // namespace

SeriesDialog::SeriesDialog(const std::vector<SeriesDescription>& series, QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget(this)) {
    setWindowTitle("Choose a series");
    setMinimumSize(760, 280);
    auto* column = new QVBoxLayout(this);
    column->addWidget(new QLabel("The folder holds several CT series. Which one is to be read?"));
    list_->setObjectName("series");
    list_->setRootIsDecorated(false);
    list_->setAllColumnsShowFocus(true);
    list_->setHeaderLabels({"", "Series", "Images", "Apart", "Kernel", "Phase", "Why"});
    for (const SeriesDescription& one : series)
        list_->addTopLevelItem(row_of(one, list_->topLevelItemCount() + 1));
    list_->header()->resizeSections(QHeaderView::ResizeToContents);
    list_->setCurrentItem(list_->topLevelItem(0));
    connect(list_, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    column->addWidget(list_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton("Open", QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    list_->setFocus();
}

int SeriesDialog::chosen() const {
    return list_->indexOfTopLevelItem(list_->currentItem()) + 1;
}

}  // namespace hepatica
