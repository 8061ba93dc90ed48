// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/branch_dock.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "core/opening/patient_image.h"
#include "core/patient/liver_segments.h"
#include "core/tree/territories/couinaud_segments.h"
#include "core/tree/territories/segment_name.h"
#include "render/palette.h"
#include "ui/colours.h"
#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QStringList columns() {
    return {Words::tr("Branch"),           Words::tr("System"),      Words::tr("Generation"),
            Words::tr("Length (mm)"),      Words::tr("Radius (mm)"), Words::tr("Segment"),
            Words::tr("Share of flow (%)")};
}

// Shows exactly this many decimals and sorts by its value.
class NumberItem : public QTableWidgetItem {
  public:
    NumberItem(double value, int decimals)
        : QTableWidgetItem(in_decimals(value, decimals)), value_(value) {
        setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    bool operator<(const QTableWidgetItem& other) const override {
        const auto* number = dynamic_cast<const NumberItem*>(&other);
        return number != nullptr && value_ < number->value_;
    }

  private:
    static QString in_decimals(double value, int decimals) {
        QLocale numbers;
        numbers.setNumberOptions(
            QLocale::OmitGroupSeparator);  // the number of a branch is read back
        return numbers.toString(value, 'f', decimals);
    }

    double value_;
};

QTableWidgetItem* number(double value, int decimals) {
    return new NumberItem(value, decimals);
}

// Shows a Roman numeral, or these words where there is none, and sorts by the numeral's value.
class SegmentItem : public QTableWidgetItem {
  public:
    explicit SegmentItem(int couinaud, const QString& else_text = {})
        : QTableWidgetItem(couinaud > 0 ? QString::fromStdString(segment_name(couinaud))
                                        : else_text),
          couinaud_(couinaud) {
        setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    bool operator<(const QTableWidgetItem& other) const override {
        const auto* segment = dynamic_cast<const SegmentItem*>(&other);
        return couinaud_ < (segment ? segment->couinaud_ : 0);
    }

  private:
    int couinaud_;  // 0 if none
};

// The branch at which the portal vein begins; none where it lies in several trees, whose first
// branches may be those of its trunk.
std::optional<int> trunk_among(const std::vector<BranchRow>& rows) {
    std::optional<int> trunk;
    for (const BranchRow& row : rows) {
        if (row.generation != 1 || row.couinaud_confidence <= 0.0) continue;
        if (trunk) return std::nullopt;
        trunk = row.branch;
    }
    return trunk;
}

// With the segment's colour in the 3D view; without a segment, why there is none. Where no segments
// are known, the note above the table says why.
QTableWidgetItem* segment(const BranchRow& row, std::optional<int> trunk) {
    if (row.couinaud > 0) {
        auto* item = new SegmentItem(row.couinaud);
        item->setData(Qt::DecorationRole, qcolor_of(palette::liver_segment(row.couinaud)));
        return item;
    }
    if (row.couinaud_confidence <= 0.0) return new SegmentItem(0);
    auto* item =
        new SegmentItem(0, row.branch == trunk ? Words::tr("trunk") : Words::tr("several"));
    item->setToolTip(Words::tr("It supplies several segments of the liver"));
    return item;
}

// Labels of the portal vein's branches; none if there is no liver or no portal vein.
std::vector<BranchLabel> labels_of(const PatientCase& patient,
                                   const std::filesystem::path& folder) {
    const Mask liver = liver_of(organ_voxels(patient, folder));
    if (liver.voxels.empty()) return {};
    const auto portal = label_portal_vein(patient.tree, liver);
    return portal ? portal->branches : std::vector<BranchLabel>{};
}

}  // namespace

BranchDock::BranchDock(Callbacks callbacks, QWidget* parent)
    : QDockWidget(Words::tr("Branches"), parent),
      callbacks_(std::move(callbacks)),
      table_(new QTableWidget),
      colours_(new QCheckBox(Words::tr("Colour by liver segment"))),
      note_(new QLabel) {
    setObjectName("Branches");
    setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    auto* row = new QHBoxLayout;
    colours_->setObjectName("segmentColours");
    colours_->setToolTip(
        Words::tr("Branches of the portal vein in the colours of Couinaud's segments"));
    note_->setObjectName("quiet");
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* save = new QPushButton(Words::tr("Save as CSV…"));
    save->setObjectName("saveBranches");
    row->addWidget(colours_);
    row->addWidget(note_, 1);
    row->addWidget(save);
    column->addLayout(row);
    table_->setObjectName("branches");
    table_->setAccessibleName(Words::tr("Branches of the vessels"));
    const QStringList heads = columns();
    table_->setColumnCount(static_cast<int>(heads.size()));
    table_->setHorizontalHeaderLabels(heads);
    table_->horizontalHeaderItem(static_cast<int>(heads.size()) - 1)
        ->setToolTip(
            Words::tr("Of what flows into the root of its own tree: a system may have several"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    QHeaderView& head = *table_->horizontalHeader();
    head.setSectionResizeMode(QHeaderView::Stretch);
    head.setDefaultAlignment(Qt::AlignCenter | Qt::Alignment(Qt::TextWordWrap));
    head.setMinimumHeight(2 * head.fontMetrics().height() + 8);  // long titles take two lines
    column->addWidget(table_);
    setWidget(content);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
        const int current = table_->currentRow();
        if (current < 0 || table_->selectedItems().isEmpty()) return;
        const int branch = table_->item(current, 0)->data(Qt::DisplayRole).toInt() - 1;
        callbacks_.choose(rows_[static_cast<std::size_t>(branch)]);
    });
    connect(colours_, &QCheckBox::toggled, this, [this] { colour_vessels(); });
    connect(save, &QPushButton::clicked, this, [this] {
        if (!rows_.empty()) callbacks_.save(branch_table_csv(rows_));
    });
}

BranchDock::~BranchDock() = default;

void BranchDock::show_patient(std::shared_ptr<const PatientCase> patient,
                              std::vector<double> flow_shares,
                              const std::filesystem::path& folder) {
    clear();
    patient_ = std::move(patient);
    flow_shares_ = std::move(flow_shares);
    folder_ = folder;
    if (isVisible()) read_labels();
}

void BranchDock::clear() {
    job_.reset();
    asked_ = false;
    asked_for_ = -1;
    patient_.reset();
    rows_.clear();
    table_->setRowCount(0);
    note_->clear();
    colours_->setEnabled(false);
}

void BranchDock::showEvent(QShowEvent* event) {
    QDockWidget::showEvent(event);
    read_labels();
}

void BranchDock::read_labels() {
    if (!patient_ || asked_) return;
    asked_ = true;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = [this](const Failure& failure) {
        show_rows({},
                  Words::tr("The segments cannot be read: %1").arg(translated(failure.problem)));
        callbacks_.failed(failure);
    };
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, patient = patient_, folder = folder_](Job&) -> std::function<void()> {
            return [this, labels = labels_of(*patient, folder)] {
                show_rows(labels,
                          Words::tr("No liver segments: they need a liver mask and a portal vein"));
            };
        },
        std::move(callbacks));
}

void BranchDock::show_rows(const std::vector<BranchLabel>& labels, const QString& why_none) {
    rows_ = branch_rows(patient_->tree, labels, flow_shares_);
    fill_table();
    colours_->setEnabled(!labels.empty());
    note_->setText(labels.empty()
                       ? why_none
                       : Words::tr("%n branch(es)", nullptr, static_cast<int>(rows_.size())));
    colour_vessels();
    choose_asked_for();
}

void BranchDock::fill_table() {
    const QSignalBlocker quiet(table_);
    table_->setSortingEnabled(false);
    table_->setRowCount(static_cast<int>(rows_.size()));
    const std::optional<int> trunk = trunk_among(rows_);
    for (int i = 0; i < table_->rowCount(); ++i) {
        const BranchRow& row = rows_[static_cast<std::size_t>(i)];
        table_->setItem(i, 0, number(row.branch + 1, 0));
        table_->setItem(i, 1, new QTableWidgetItem(translated(title_of(row.system))));
        table_->setItem(i, 2, number(row.generation, 0));
        table_->setItem(i, 3, number(row.length_mm, 1));
        table_->setItem(i, 4, number(row.radius_mm, 2));
        table_->setItem(i, 5, segment(row, trunk));
        table_->setItem(i, 6,
                        row.flow_share ? number(100.0 * *row.flow_share, 2) : new QTableWidgetItem);
    }
    table_->setSortingEnabled(true);
    table_->sortByColumn(0, Qt::AscendingOrder);
}

void BranchDock::select(int branch) {
    const QSignalBlocker quiet(table_);
    for (int i = 0; i < table_->rowCount(); ++i)
        if (table_->item(i, 0)->data(Qt::DisplayRole).toInt() == branch + 1) table_->selectRow(i);
}

void BranchDock::show_branch(int branch) {
    asked_for_ = branch;
    show();
    raise();
    if (!rows_.empty()) choose_asked_for();
}

void BranchDock::choose_asked_for() {
    const int branch = std::exchange(asked_for_, -1);
    for (int i = 0; branch >= 0 && i < table_->rowCount(); ++i) {
        if (table_->item(i, 0)->data(Qt::DisplayRole).toInt() != branch + 1) continue;
        table_->clearSelection();  // so that selecting it again sends the signal
        table_->selectRow(i);
        table_->scrollToItem(table_->item(i, 0));
    }
}

void BranchDock::colour_vessels() {
    std::vector<std::uint8_t> segments;
    if (colours_->isChecked() && colours_->isEnabled())
        for (const BranchRow& row : rows_)
            segments.push_back(static_cast<std::uint8_t>(row.couinaud));
    callbacks_.colour(segments);
}

}  // namespace hepatica
