// SPDX-License-Identifier: GPL-3.0-or-later
// The user guide: the pages of assets/guide, read inside the program, in the window's language.
#pragma once

#include <QDialog>
#include <QString>

class QTextBrowser;

namespace hepatica {

// UI thread. Throws InputError where the pages are not installed.
class Guide : public QDialog {
  public:
    explicit Guide(QWidget* parent = nullptr);

    void show_page(const QString& name);  // such as "patient.md"
    QTextBrowser& browser() { return *browser_; }

  private:
    void lay_out();

    QTextBrowser* browser_;
    QString folder_;
};

}  // namespace hepatica
