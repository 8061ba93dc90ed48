// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/places_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lesson/lesson_draft.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_editor/new_parts.h"
#include "ui/patient_place.h"
#include "ui/words.h"

namespace hepatica {
namespace {

const ScriptPlace half_way{std::nullopt, 0.5};

// To a tenth of a millimetre.
Vec3 rounded(const Vec3& place_mm) {
    return (10.0 * place_mm).array().round() / 10.0;
}

QLabel* text_of_point(const Vec3& at) {
    auto* label = new QLabel(Words::tr("at %1").arg(patient_place(at, 1)));
    label->setToolTip(
        Words::tr("From the origin of the CT: %1").arg(patient_place_in_words(at, 1)));
    return label;
}

QLabel* quiet(const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName("quiet");
    label->setWordWrap(true);
    return label;
}

}  // namespace

PlacesPage::PlacesPage(Changes changes, std::function<void()> ask_for_place,
                       std::function<void()> ask_no_more,
                       std::function<std::vector<TumourPlace>()> tumours,
                       std::function<bool(const ScriptPlace&)> is_hidden)
    : LessonPage(std::move(changes)),
      ask_for_place_(std::move(ask_for_place)),
      ask_no_more_(std::move(ask_no_more)),
      tumours_(std::move(tumours)),
      is_hidden_(std::move(is_hidden)),
      marks_(new QVBoxLayout),
      target_(new QVBoxLayout),
      add_target_(new QPushButton(Words::tr("&Give it a target"))),
      tumour_(new QPushButton(Words::tr("A tumour as the target"))) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(new QLabel("<b>" + Words::tr("Marks") + "</b>"));
    column->addWidget(quiet(Words::tr(
        "Yellow balls on the vessels that goals speak of; they move with them. A share of "
        "the longest path (0 % the root, 100 % its end) is found on every patient; a point "
        "that is clicked on belongs to the patient who is shown.")));
    column->addLayout(marks_);
    auto* add = new QPushButton(Words::tr("&Add a mark"));
    add->setObjectName("lessonAddMark");
    connect(add, &QPushButton::clicked, this, [this] { add_mark(); });
    column->addWidget(add, 0, Qt::AlignLeft);
    column->addSpacing(12);
    column->addWidget(new QLabel("<b>" + Words::tr("Target of the drug") + "</b>"));
    column->addWidget(
        quiet(Words::tr("The vessels beyond this place. What is delivered there is the dose in "
                        "the target, all other is elsewhere.")));
    column->addLayout(target_);
    add_target_->setObjectName("lessonAddTarget");
    connect(add_target_, &QPushButton::clicked, this,
            [this] { change_shape([](Lesson& lesson) { lesson.target = half_way; }); });
    column->addWidget(add_target_, 0, Qt::AlignLeft);
    tumour_->setObjectName("lessonTumour");
    tumour_->setToolTip(
        Words::tr("The target begins where the portal or arterial vessels pass nearest to the "
                  "tumour's middle; other branches that feed it are not in the target"));
    tumour_->setMenu(new QMenu(tumour_));
    column->addWidget(tumour_, 0, Qt::AlignLeft);
    column->addStretch(1);
}

void PlacesPage::fill(const Lesson& lesson) {
    wait_no_more();
    names_ = lesson.mark_names();
    clear_rows(*marks_);
    for (std::size_t i = 0; i < lesson.marks.size(); ++i)
        marks_->addWidget(
            make_row(static_cast<int>(i), lesson.marks[i].name, lesson.marks[i].place));
    clear_rows(*target_);
    if (lesson.target) target_->addWidget(make_row(target, "", *lesson.target));
    add_target_->setVisible(!lesson.target);
    offer_tumours();
}

void PlacesPage::offer_tumours() {
    for (QAction* gone : tumour_->menu()->actions()) {
        tumour_->menu()->removeAction(gone);
        gone->deleteLater();  // it may be the one that was chosen
    }
    for (const TumourPlace& tumour : tumours_()) {
        QAction* action = tumour_->menu()->addAction(
            Words::tr("Tumour %1 (%L2 ml), its nearest branch %L3 mm from its middle")
                .arg(tumour.number)
                .arg(tumour.volume_ml, 0, 'f', 1)
                .arg(tumour.aside_mm, 0, 'f', 0));
        connect(action, &QAction::triggered, this, [this, from_mm = tumour.from_mm] {
            wait_no_more();
            set_place(target, {rounded(from_mm), std::nullopt}, false);
        });
    }
    tumour_->setVisible(!tumour_->menu()->isEmpty());
}

QWidget* PlacesPage::make_row(int place, const std::string& name, const ScriptPlace& at) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    const QString prefix = place == target ? "target" : "mark" + QString::number(place);
    if (place != target) {
        auto* text = new QLineEdit(QString::fromStdString(name));
        text->setObjectName(prefix + "name");
        text->setAccessibleName(Words::tr("Name of the mark"));
        connect(text, &QLineEdit::editingFinished, this,
                [this, place, text] { rename(place, *text); });
        line->addWidget(text, 1);
    }
    if (at.point_mm) {
        line->addWidget(text_of_point(*at.point_mm));
        auto* share = new QPushButton(Words::tr("As a share"));
        share->setObjectName(prefix + "asShare");
        connect(share, &QPushButton::clicked, this,
                [this, place] { set_place(place, half_way, false); });
        line->addWidget(share);
    } else {
        auto* share = new DecimalSpinBox(0.0, 100.0, 100.0 * at.share_of_longest_path.value_or(0.0),
                                         1, Words::tr("% of the longest path"));
        share->setObjectName(prefix + "share");
        share->setAccessibleName(Words::tr("Share of the longest path"));
        connect(share, &DecimalSpinBox::valueChanged, this, [this, place](double value) {
            set_place(place, {std::nullopt, value / 100.0}, true);
        });
        line->addWidget(share);
    }
    auto* click = new QPushButton(Words::tr("Click on it"));
    click->setObjectName(prefix + "click");
    click->setToolTip(Words::tr("The next click on a vessel in the view sets the place"));
    connect(click, &QPushButton::clicked, this, [this, place] { ask(place); });
    line->addWidget(click);
    auto* gone = new QPushButton(Words::tr("Remove"));
    gone->setObjectName(prefix + "remove");
    connect(gone, &QPushButton::clicked, this, [this, place] { remove(place); });
    line->addWidget(gone);
    if (place == target) line->addStretch(1);
    return row;
}

void PlacesPage::add_mark() {
    const auto is_hidden = [this](double share) { return is_hidden_({std::nullopt, share}); };
    change_shape([&](Lesson& lesson) {
        lesson.marks.push_back({free_mark_name_in_words(lesson), free_place(lesson, is_hidden)});
    });
}

void PlacesPage::ask(int place) {
    waits_for_ = place;
    ask_for_place_();
}

void PlacesPage::wait_no_more() {
    if (std::exchange(waits_for_, nobody) != nobody) ask_no_more_();
}

void PlacesPage::place_clicked(const Vec3& place_mm) {
    const int place = std::exchange(waits_for_, nobody);
    if (place == nobody) return;
    set_place(place, {rounded(place_mm), std::nullopt}, false);
}

// Keeps the old name if the new one is empty or another mark has it.
void PlacesPage::rename(int mark, QLineEdit& field) {
    if (showing()) return;  // a removed row loses the focus
    const std::string name = field.text().trimmed().toStdString();
    std::string& present = names_[static_cast<std::size_t>(mark)];
    if (name.empty() || (name != present && std::ranges::find(names_, name) != names_.end()))
        return field.setText(QString::fromStdString(present));
    present = name;
    change_value("",
                 [&](Lesson& lesson) { lesson.marks[static_cast<std::size_t>(mark)].name = name; });
}

void PlacesPage::set_place(int place, const ScriptPlace& at, bool same_row) {
    const auto set = [&](Lesson& lesson) {
        if (place == target) {
            lesson.target = at;
            lesson.target_tie.reset();
        } else {
            LessonMark& mark = lesson.marks.at(static_cast<std::size_t>(place));
            mark.place = at;
            mark.tie.reset();
        }
    };
    if (same_row)
        change_value("place" + std::to_string(place), set);
    else
        change_shape(set);
}

void PlacesPage::remove(int place) {
    change_shape([&](Lesson& lesson) {
        if (place != target) return remove_mark(lesson, place);
        lesson.target.reset();
        lesson.target_tie.reset();
    });
}

}  // namespace hepatica
