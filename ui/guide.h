// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that shows the user guide, the pages of assets/guide, in the window's language.
#pragma once

#include <QDialog>
#include <QString>

class QTextBrowser;

namespace hepatica {

// UI thread only. The constructor throws InputError if the pages are not installed.
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
