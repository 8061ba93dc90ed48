// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_log.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTime>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/branch_links.h"
#include "ui/core_words.h"
#include "ui/on_screen.h"
#include "ui/plain_text.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Makes a row as high as its text wrapped to the column's width; by default a tree view reserves
// one line.
class WrappingDelegate : public QStyledItemDelegate {
  public:
    explicit WrappingDelegate(QTreeWidget* list) : QStyledItemDelegate(list), list_(list) {}
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem wrapped = option;
        wrapped.rect = QRect(0, 0, list_->columnWidth(index.column()), QWIDGETSIZE_MAX);
        return QStyledItemDelegate::sizeHint(wrapped, index);
    }

  private:
    QTreeWidget* list_;
};

// The branch that a message names; none where that is past, and the number may be another's.
std::optional<int> branch_of(const QTreeWidgetItem* item) {
    return item == nullptr || item->isDisabled() ? std::nullopt : branch_named_in(item->text(3));
}

}  // namespace

MessageLog::MessageLog(QWidget* parent) : QDialog(parent), list_(new QTreeWidget(this)) {
    setWindowTitle(Words::tr("Messages"));
    resize_on_screen(*this, {820, 380});
    list_->setHeaderLabels(
        {Words::tr("Time"), Words::tr("Kind"), Words::tr("About"), Words::tr("Message")});
    list_->setRootIsDecorated(false);
    list_->setWordWrap(true);
    list_->setTextElideMode(Qt::ElideNone);
    list_->setAccessibleName(Words::tr("Messages"));
    for (int column = 0; column < 3; ++column)
        list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(3, QHeaderView::Stretch);
    list_->setItemDelegate(new WrappingDelegate(list_));
    connect(list_->header(), &QHeaderView::sectionResized, list_, &QTreeWidget::doItemsLayout,
            Qt::QueuedConnection);
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](const QTreeWidgetItem* item) { show_branch_of(item); });
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] { offer_branch(); });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(Words::tr("Copy all"), QDialogButtonBox::ActionRole);
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(as_text()); });
    show_branch_ = buttons->addButton(Words::tr("Show the branch"), QDialogButtonBox::ActionRole);
    show_branch_->setObjectName("logShowBranch");
    show_branch_->setAutoDefault(false);
    show_branch_->setToolTip(
        Words::tr("The one that the chosen message names, in the table and the "
                  "view; so does a double click on the message"));
    connect(show_branch_, &QPushButton::clicked, this,
            [this] { show_branch_of(list_->currentItem()); });
    offer_branch();
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    auto* column = new QVBoxLayout(this);
    column->addWidget(list_);
    column->addWidget(buttons);
}

void MessageLog::add_warning(const QString& source, const QString& text,
                             std::function<bool()> holds) {
    // What is said again is said of now: the one that is past stays past.
    std::erase_if(standing_, [&](const Standing& other) {
        return other.item->isDisabled() && other.item->text(3) == text;
    });
    QTreeWidgetItem* item = add(Words::tr("Warning"), source, text);
    if (holds) standing_.push_back({item, std::move(holds)});
}

void MessageLog::settle_warning(const QString& text) {
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        QTreeWidgetItem& item = *list_->topLevelItem(row);
        if (item.text(1) != Words::tr("Warning") || item.text(3) != text) continue;
        mark(item, true);
        std::erase_if(standing_, [&](const Standing& other) { return other.item == &item; });
    }
}

void MessageLog::settle() {
    for (const Standing& warning : standing_)
        if (const bool past = !warning.holds(); past != warning.item->isDisabled())
            mark(*warning.item, past);
}

void MessageLog::mark(QTreeWidgetItem& item, bool past) {
    item.setText(1, past ? Words::tr("Warning, no longer so") : Words::tr("Warning"));
    item.setDisabled(past);
    offer_branch();
}

void MessageLog::offer_branch() {
    show_branch_->setEnabled(branch_of(list_->currentItem()).has_value());
}

void MessageLog::show_branch_of(const QTreeWidgetItem* item) {
    const std::optional<int> branch = branch_of(item);
    if (!branch || !on_branch) return;
    hide();  // it would lie over the branch
    on_branch(*branch);
}

void MessageLog::add_note(const QString& source, const QString& text) {
    add(Words::tr("Note"), source, text);
}

void MessageLog::add_failure(const QString& source, const Failure& failure) {
    QString text = translated(failure.problem);
    if (!failure.place.empty() && !names_its_place(failure))
        text.prepend(place_in_words(failure) + ": ");
    if (!failure.remedy.empty()) text += ". " + translated(failure.remedy);
    add(Words::tr("Failure"), source, text);
}

QTreeWidgetItem* MessageLog::add(const QString& kind, const QString& source, const QString& text) {
    auto* item =
        new QTreeWidgetItem(list_, {QTime::currentTime().toString("HH:mm:ss"), kind, source, text});
    for (int column = 0; column < 4; ++column) item->setTextAlignment(column, Qt::AlignTop);
    item->setToolTip(3, as_plain(branch_named_in(text)
                                     ? text + "\n" + Words::tr("A double click shows the branch")
                                     : text));
    list_->scrollToItem(item);
    return item;
}

QString MessageLog::as_text() const {
    QStringList lines;
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        const QTreeWidgetItem& item = *list_->topLevelItem(row);
        QStringList columns;
        for (int column = 0; column < 4; ++column)
            columns << item.text(column).replace('\n', ' ').replace('\t', ' ');
        lines << columns.join('\t');
    }
    return lines.isEmpty() ? QString() : lines.join('\n') + '\n';
}

}  // namespace hepatica
