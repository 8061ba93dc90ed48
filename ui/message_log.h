// SPDX-License-Identifier: GPL-3.0-or-later
// What was warned of and what failed since the program began, with time and source: the message bar
// shows only the last of them. To be read, and to be copied into a letter.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>

#include "ui/background_job.h"

class QTreeWidget;

namespace hepatica {

class MessageLog : public QDialog {
  public:
    explicit MessageLog(QWidget* parent = nullptr);

    // `source`: the job or file that the message is about.
    void add_warning(const QString& source, const QString& text);
    void add_failure(const QString& source, const Failure& failure);

    // A branch, from 0, that the message names on which somebody double-clicked or pressed Enter.
    std::function<void(int branch)> on_branch;

    // One line a message, columns parted by tabs: time, kind, source, text.
    QString as_text() const;

  private:
    void add(const QString& kind, const QString& source, const QString& text);

    QTreeWidget* list_;
};

}  // namespace hepatica
