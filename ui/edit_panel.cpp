// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

struct EditTool {
    TreeEditKind kind;
    const char* name;
    const char* tip;
};

constexpr std::array<EditTool, 7> tools{{
    {TreeEditKind::cut_link, Words::id("Cut the vessel"), Words::id("Click where to cut it")},
    {TreeEditKind::add_link, Words::id("Link two vessels"),
     Words::id("Click the one, then the other")},
    {TreeEditKind::delete_branch, Words::id("Delete a branch"),
     Words::id("Click it; all that hangs on it goes with it")},
    {TreeEditKind::delete_tree, Words::id("Delete a whole tree"),
     Words::id("Click any branch of it; all that hangs on its root goes")},
    {TreeEditKind::set_root, Words::id("Set the root"),
     Words::id("Click near the end where blood comes in")},
    {TreeEditKind::reassign_system, Words::id("Set a branch's system"),
     Words::id("Click a branch; it and what hangs on it take the system below. What it hangs on "
               "keeps its own")},
    {TreeEditKind::seed_system, Words::id("Set a whole vessel's system"),
     Words::id("Click anywhere on a vessel; what hangs on it takes the system below, and towards "
               "the root as much as belongs with it")},
}};

QListWidget* make_list(QWidget* parent, const QString& name) {
    auto* list = new QListWidget(parent);
    list->setWordWrap(true);  // the end of a line names the vessel
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setAccessibleName(name);
    list->setMaximumHeight(5 * list->fontMetrics().height() + 8);
    return list;
}

}  // namespace

EditPanel::EditPanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_tools());
    // Above the gaps, which may be many, so that the last correction stays visible.
    column->addWidget(make_edits());
    column->addWidget(make_bridges());
    state_ = new QLabel(this);
    state_->setObjectName("quiet");
    state_->setWordWrap(true);
    column->addWidget(state_);
    column->addStretch(1);
    show_bridges({});
    show_edits({});
    show_history(false, false);
}

QWidget* EditPanel::make_tools() {
    auto* box = new QGroupBox(Words::tr("A click in Edit mode"), this);
    auto* form = new QFormLayout(box);
    tool_ = new QComboBox(box);
    tool_->setAccessibleName(Words::tr("Tool of the edit"));
    tool_->setObjectName("EditTool");
    for (const EditTool& tool : tools) {
        tool_->addItem(Words::tr(tool.name));
        tool_->setItemData(tool_->count() - 1, Words::tr(tool.tip), Qt::ToolTipRole);
    }
    form->addRow(Words::tr("does"), tool_);
    auto* tip = new QLabel(Words::tr(tools[0].tip), box);
    tip->setObjectName("quiet");
    tip->setWordWrap(true);
    form->addRow(tip);
    auto* drawing =
        new QLabel(Words::tr("A vessel that is missing is drawn in the slices (F7)"), box);
    drawing->setObjectName("quiet");
    drawing->setWordWrap(true);
    form->addRow(drawing);
    system_ = new QComboBox(box);
    system_->setAccessibleName(Words::tr("System that a branch is given to"));
    system_->setObjectName("EditSystem");
    for (const VascularSystem system : vascular_systems)
        system_->addItem(translated(title_of(system)), number_of(system));
    system_->setEnabled(false);
    form->addRow(Words::tr("System"), system_);
    auto* chosen = new QPushButton(Words::tr("Do it to the branch chosen in the table"), box);
    chosen->setObjectName("editChosenBranch");
    chosen->setToolTip(
        Words::tr("As a click on the middle of the branch whose row is chosen in the table of "
                  "branches (F6) would: for one that is too short to click on"));
    form->addRow(chosen);
    connect(chosen, &QPushButton::clicked, this, [this] { callbacks_.take_chosen(); });
    connect(tool_, &QComboBox::currentIndexChanged, this, [this, tip](int index) {
        tip->setText(Words::tr(tools.at(static_cast<std::size_t>(index)).tip));
        system_->setEnabled(tool() == TreeEditKind::reassign_system ||
                            tool() == TreeEditKind::seed_system);
        if (callbacks_.tool_changed) callbacks_.tool_changed();
    });
    return box;
}

QWidget* EditPanel::make_bridges() {
    auto* box = new QGroupBox(Words::tr("Gaps and doubtful branches"), this);
    auto* column = new QVBoxLayout(box);
    bridges_ = make_list(box, Words::tr("Gaps and doubtful branches"));
    bridges_->setObjectName("gaps");
    bridges_->setToolTip(Words::tr(
        "Above stands what the reconstruction has bridged, the doubtful first; below it what "
        "may be a vessel: gaps between two, and branches that are too faint to be "
        "believed, with the confidence that they are vessels. For branches it was "
        "learned on synthetic patients: of what was offered on two real ones experts had "
        "drawn a quarter to a half. They are dashed in the view, branches in Edit mode. "
        "A click on a dashed line takes it; in Edit mode, where a click corrects vessels, it "
        "only chooses it in this list. What is chosen stands out in the view and as a line in "
        "the slices."));
    column->addWidget(bridges_);
    add_confidence_slider(*column);
    add_decisions(*column);
    // The current row may be none that anybody chose: a list that gets the focus takes its first.
    connect(bridges_, &QListWidget::itemSelectionChanged, this,
            [this] { chosen_bridge_changed(); });
    return box;
}

int EditPanel::chosen_bridge() const {
    const QList<QListWidgetItem*> chosen = bridges_->selectedItems();
    return chosen.isEmpty() ? -1 : bridges_->row(chosen.front());
}

void EditPanel::choose_bridge(int row) {
    row < 0 || row >= bridges_->count() ? bridges_->clearSelection() : bridges_->setCurrentRow(row);
}

void EditPanel::chosen_bridge_changed() {
    const int row = chosen_bridge();
    accept_->setEnabled(row >= built_);
    refuse_->setEnabled(row >= 0);
    if (callbacks_.choose_bridge) callbacks_.choose_bridge(row);
}

void EditPanel::accept_chosen() {
    const int row = chosen_bridge();
    if (row < built_) return;
    decided_ = true;
    callbacks_.accept_bridge(row);
}

void EditPanel::refuse_chosen() {
    const int row = chosen_bridge();
    if (row < 0) return;
    decided_ = true;
    callbacks_.refuse_bridge(row);
}

void EditPanel::add_decisions(QVBoxLayout& column) {
    auto* one = new QHBoxLayout;
    accept_ = new QPushButton(Words::tr("Take it"), this);
    accept_->setObjectName("acceptGap");
    accept_->setToolTip(Words::tr("A gap is bridged, a branch is drawn"));
    refuse_ = new QPushButton(Words::tr("Refuse it"), this);
    refuse_->setObjectName("refuseGap");
    refuse_->setToolTip(
        Words::tr("It is offered no more. What the reconstruction has bridged is cut in its "
                  "middle. Undo takes that back."));
    one->addWidget(accept_);
    one->addWidget(refuse_);
    column.addLayout(one);
    accept_all_ = new QPushButton(Words::tr("Take all that are listed (%1)").arg(0), this);
    accept_all_->setObjectName("acceptAll");
    accept_all_->setToolTip(
        Words::tr("All that are offered with this confidence or more, best first; what another one "
                  "made needless is left out"));
    column.addWidget(accept_all_);
    connect(accept_, &QPushButton::clicked, this, [this] { accept_chosen(); });
    connect(bridges_, &QListWidget::itemDoubleClicked, this, [this] { accept_chosen(); });
    connect(refuse_, &QPushButton::clicked, this, [this] { refuse_chosen(); });
    connect(accept_all_, &QPushButton::clicked, this, [this] { callbacks_.accept_all(); });
}

void EditPanel::add_confidence_slider(QVBoxLayout& column) {
    auto* row = new QHBoxLayout;
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName("bridgeConfidence");
    slider->setAccessibleName(Words::tr("Least confidence of what is offered"));
    slider->setRange(0, 100);
    auto* value = new QLabel(Words::tr("of %1 % or more").arg(0), this);
    value->setMinimumWidth(
        value->fontMetrics().horizontalAdvance(Words::tr("of %1 % or more").arg(100)));
    row->addWidget(slider);
    row->addWidget(value);
    column.addLayout(row);
    connect(slider, &QSlider::valueChanged, this, [this, value](int percent) {
        value->setText(Words::tr("of %1 % or more").arg(percent));
        if (callbacks_.least_confidence) callbacks_.least_confidence(0.01 * percent);
    });
}

QWidget* EditPanel::make_edits() {
    auto* box = new QGroupBox(Words::tr("Done so far"), this);
    auto* column = new QVBoxLayout(box);
    edits_ = make_list(box, Words::tr("Edits"));
    edits_->setSelectionMode(QAbstractItemView::NoSelection);
    column->addWidget(edits_);
    auto* row = new QHBoxLayout;
    undo_ = new QPushButton(Words::tr("Undo"), box);
    redo_ = new QPushButton(Words::tr("Redo"), box);
    connect(undo_, &QPushButton::clicked, this, [this] { callbacks_.undo(); });
    connect(redo_, &QPushButton::clicked, this, [this] { callbacks_.redo(); });
    row->addWidget(undo_);
    row->addWidget(redo_);
    column->addLayout(row);
    return box;
}

TreeEditKind EditPanel::tool() const {
    return tools.at(static_cast<std::size_t>(tool_->currentIndex())).kind;
}

QString EditPanel::tool_name() const {
    return tool_->currentText();
}

VascularSystem EditPanel::system() const {
    return system_numbered(system_->currentData().toInt()).value_or(VascularSystem::unknown);
}

void EditPanel::show_bridges(const QStringList& offered, const QStringList& built,
                             std::size_t hidden) {
    const int row = chosen_bridge();
    const QString before = row < 0 ? QString() : bridges_->item(row)->text();
    const QSignalBlocker quiet(bridges_);
    bridges_->clear();
    bridges_->addItems(built + offered);
    built_ = static_cast<int>(built.size());
    const int count = bridges_->count();
    const bool goes_on = std::exchange(decided_, false);
    const bool same = row >= 0 && row < count && bridges_->item(row)->text() == before;
    if (row >= 0 && count > 0 && (goes_on || same))
        bridges_->setCurrentRow(std::min(row, count - 1));
    else
        bridges_->setCurrentRow(-1);
    accept_->setEnabled(chosen_bridge() >= built_);
    refuse_->setEnabled(chosen_bridge() >= 0);
    const bool none = count == 0;
    bridges_->setEnabled(!none);
    accept_all_->setEnabled(!offered.isEmpty());
    accept_all_->setText(Words::tr("Take all that are listed (%1)").arg(offered.size()));
    if (none)
        bridges_->addItem(hidden > 0 ? Words::tr("none; with less confidence: %1").arg(hidden)
                                     : Words::tr("none"));
}

void EditPanel::show_edits(const QStringList& lines) {
    edits_->clear();
    edits_->addItems(lines);
    for (int row = 0; row < edits_->count(); ++row) edits_->item(row)->setToolTip(lines[row]);
    edits_->scrollToBottom();
}

void EditPanel::show_history(bool can_undo, bool can_redo) {
    undo_->setEnabled(can_undo);
    redo_->setEnabled(can_redo);
}

void EditPanel::show_state(const QString& text) {
    state_->setText(text);
}

}  // namespace hepatica
