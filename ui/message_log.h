// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog with all warnings and failures since the start, with time and source; the message bar
// shows only the last one. The text can be copied.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>
#include <vector>

#include "ui/background_job.h"

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace hepatica {

// UI thread only.
class MessageLog : public QDialog {
  public:
    explicit MessageLog(QWidget* parent = nullptr);

    // `source`: the job or file that the message is about.
    // `holds`: whether it is so, asked by settle(). Without one only settle_warning() ends it.
    void add_warning(const QString& source, const QString& text, std::function<bool()> holds = {});
    // Marks the warnings of these words as past: a branch that they name may be another one now.
    void settle_warning(const QString& text);
    // Marks those as past that hold no longer, and those as present that hold again, as by Redo.
    void settle();
    // What happened for a moment and asks for nothing: it counts to no warnings.
    void add_note(const QString& source, const QString& text);
    void add_failure(const QString& source, const Failure& failure);

    // Called with the index of a branch when a message that names it is double-clicked or Enter is
    // pressed.
    std::function<void(int branch)> on_branch;

    // One line per message, columns separated by tabs: time, kind, source, text.
    QString as_text() const;

  private:
    QTreeWidgetItem* add(const QString& kind, const QString& source, const QString& text);
    void mark(QTreeWidgetItem& item, bool past);
    void offer_branch();
    void show_branch_of(const QTreeWidgetItem* item);

    QTreeWidget* list_;
    QPushButton* show_branch_;
    struct Standing {
        QTreeWidgetItem* item;
        std::function<bool()> holds;
    };
    std::vector<Standing> standing_;  // those that were not said again since, and not settled
};

}  // namespace hepatica
