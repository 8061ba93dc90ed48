// SPDX-License-Identifier: GPL-3.0-or-later
// Table of a lesson's bounds, one row each: quantity, mark, at least or at most, and the number
// with its unit.
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "core/lesson/predicate.h"

class QVBoxLayout;

namespace hepatica {

// UI thread only.
class BoundsTable : public QWidget {
  public:
    // `row`: index of the changed row; empty if a row was added or removed.
    using Changed =
        std::function<void(const std::string& row, const std::vector<Predicate>& bounds)>;
    // `name` is the object name; fields are named by it, the row's index and their role
    // ("goal0quantity"). `first` is the bound of a row that is added.
    BoundsTable(const QString& title, const QString& name, const Predicate& first, Changed changed);

    // Replaces all rows; `marks` are the names to choose from, empty: none.
    void show_bounds(const std::vector<Predicate>& bounds, const std::vector<std::string>& marks);
    const std::vector<Predicate>& bounds() const { return bounds_; }

  private:
    QWidget* make_row(std::size_t index);
    void choose_quantity(std::size_t index, int chosen);
    void fill();
    void set(std::size_t index, const Predicate& bound, bool other_quantity);

    QString name_;
    Predicate first_;
    Changed changed_;
    std::vector<Predicate> bounds_;
    std::vector<std::string> marks_;
    QVBoxLayout* rows_;
    bool filling_ = false;
};

}  // namespace hepatica
