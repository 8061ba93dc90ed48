// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/library_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/lesson_file.h"
#include "core/patient/patient_case.h"
#include "ui/case_lessons.h"
#include "ui/message_bar.h"
#include "ui/on_screen.h"
#include "ui/packed_lessons.h"
#include "ui/paths.h"
#include "ui/save_file_dialog.h"
#include "ui/untinted_icon.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

bool is_taken(const fs::path& folder, const fs::path& name) {
    return fs::exists(folder / fs::path(name).concat(".hep")) ||
           fs::exists(folder / fs::path(name).concat(".hepz"));
}

// "anton 2", or the first free number after it.
fs::path free_name(const fs::path& folder, const fs::path& name) {
    for (int number = 2;; ++number) {
        const fs::path other = fs::path(name).concat(" " + std::to_string(number));
        if (!is_taken(folder, other)) return other;
    }
}

QString what_was_given(const fs::path& to, std::size_t lessons) {
    if (lessons == 0) return Words::tr("Saved: %1. The CT is not in it.").arg(to_text(to));
    return Words::tr("Saved: %1. It holds the case and %n lesson(s) for this patient, not the CT.",
                     nullptr, static_cast<int>(lessons))
        .arg(to_text(to));
}

// Empty where no lesson came with the case.
QString what_came_with_it(const std::vector<fs::path>& lessons) {
    if (lessons.empty()) return {};
    QStringList names;
    for (const fs::path& file : lessons) names << to_text(file.filename());
    return Words::tr("%n lesson(s) for this patient came with the case and lie beside it: %1",
                     nullptr, static_cast<int>(lessons.size()))
        .arg(names.join(", "));
}

}  // namespace

LibraryDialog::LibraryDialog(Settings& settings, Ways ways, QWidget* parent)
    : QDialog(parent), settings_(settings), ways_(std::move(ways)) {
    setWindowTitle(Words::tr("Library of cases"));
    resize_on_screen(*this, {940, 560});
    build();
}

LibraryDialog::~LibraryDialog() = default;

void LibraryDialog::build() {
    auto* column = new QVBoxLayout(this);
    auto* row = new QHBoxLayout;
    folder_ = new QLabel;
    folder_->setObjectName("libraryFolder");
    folder_->setMinimumWidth(1);
    folder_->setTextFormat(Qt::PlainText);
    row->addWidget(folder_, 1);
    choose_ = new QPushButton(Words::tr("&Another folder…"));
    choose_->setAutoDefault(false);
    connect(choose_, &QPushButton::clicked, this, [this] { choose_folder(); });
    row->addWidget(choose_);
    column->addLayout(row);
    auto* middle = new QHBoxLayout;
    middle->addWidget(cases_above_messages(), 1);
    middle->addLayout(of_chosen_case());
    column->addLayout(middle, 1);
    auto* foot = new QHBoxLayout;
    waits_ = new QLabel;
    waits_->setObjectName("libraryWaits");
    foot->addWidget(waits_);
    foot->addWidget(buttons(), 1);
    column->addLayout(foot);
}

// A line is kept free for messages, so that no picture is covered, or moves under the mouse, where
// one comes or goes. One that is opened takes what it needs beyond that from the list's foot.
QWidget* LibraryDialog::cases_above_messages() {
    auto* cases = new QWidget;
    auto* column = new QVBoxLayout(cases);
    column->setContentsMargins(0, 0, 0, 0);
    list_ = new QListWidget;
    list_->setObjectName("library");
    list_->setAccessibleName(Words::tr("Cases"));
    list_->setViewMode(QListView::IconMode);
    list_->setIconSize(QSize(180, 150));
    list_->setGridSize(QSize(196, 184));
    list_->setResizeMode(QListView::Adjust);
    list_->setMovement(QListView::Static);
    list_->setWordWrap(true);
    column->addWidget(list_);
    messages_ = new MessageBar(cases, Qt::BottomEdge);
    const int line = messages_->height_of_line();
    column->setContentsMargins(0, 0, 0, line);
    messages_->on_cover = [this, column, line] {
        column->setContentsMargins(0, 0, 0, std::max(line, messages_->covered()));
    };
    connect(list_, &QListWidget::currentRowChanged, this, [this] { show_chosen(); });
    connect(list_, &QListWidget::itemActivated, this, [this] { open_->click(); });
    return cases;
}

QLayout* LibraryDialog::of_chosen_case() {
    facts_ = new QLabel;
    facts_->setObjectName("libraryFacts");
    facts_->setWordWrap(true);
    facts_->setAlignment(Qt::AlignTop);
    facts_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(300);
    scroll->setWidget(facts_);
    lessons_ = new CaseLessons([this](const ShelvedLesson& lesson) { begin(lesson); });
    lessons_->setFixedWidth(scroll->maximumWidth());
    auto* of_case = new QVBoxLayout;
    of_case->addWidget(scroll, 3);
    of_case->addWidget(lessons_, 2);
    return of_case;
}

QWidget* LibraryDialog::buttons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    open_ = buttons->addButton(Words::tr("&Open"), QDialogButtonBox::ActionRole);
    open_->setObjectName("libraryOpen");
    open_->setDefault(true);
    take_ = buttons->addButton(Words::tr("&Import a case…"), QDialogButtonBox::ActionRole);
    give_ = buttons->addButton(Words::tr("&Save as one file…"), QDialogButtonBox::ActionRole);
    connect(open_, &QPushButton::clicked, this, [this] {
        if (const ShelvedCase* one = chosen(); one != nullptr && one->readable) {
            hide();
            ways_.open(to_text(one->place));
        }
    });
    connect(take_, &QPushButton::clicked, this, [this] { ask_what_to_take_in(); });
    connect(give_, &QPushButton::clicked, this, [this] { ask_where_to_give(); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    return buttons;
}

void LibraryDialog::ask_what_to_take_in() {
    const QString from =
        QFileDialog::getOpenFileName(this, Words::tr("Import a case"), settings_.last_folder(),
                                     Words::tr("Cases in one file (*.hepz)"));
    if (!from.isEmpty()) take_in(to_path(from));
}

void LibraryDialog::ask_where_to_give() {
    const ShelvedCase* one = chosen();
    if (one == nullptr) return;
    const QString to = ask_where_to_save_file(*this, Words::tr("Save as one file"),
                                              settings_.last_folder() + "/" + one->name + ".hepz",
                                              Words::tr("Cases in one file (*.hepz)"));
    if (to.isEmpty()) return;
    give_away(to_path(to.endsWith(".hepz", Qt::CaseInsensitive) ? to : to + ".hepz"));
}

void LibraryDialog::begin(const ShelvedLesson& lesson) {
    const ShelvedCase* one = chosen();
    if (one == nullptr || !one->readable) return;
    hide();
    ways_.begin_lesson(lesson, to_text(one->place));
}

void LibraryDialog::open_library() {
    show();
    raise();
    refresh();
}

void LibraryDialog::open_and_take_in(const fs::path& from) {
    open_library();
    do_when_idle([this, from] { take_in(from); });
}

void LibraryDialog::do_when_idle(std::function<void()> what) {
    when_idle_.push_back(std::move(what));
    // Otherwise the end of the job, or the event that it has posted, comes to it.
    if (!busy_ && when_idle_.size() == 1) do_what_waits();
}

void LibraryDialog::do_what_waits() {
    while (!busy_ && !when_idle_.empty()) {
        const std::function<void()> what = std::move(when_idle_.front());
        when_idle_.pop_front();
        what();
    }
}

void LibraryDialog::refresh() {
    if (!isVisible()) return;
    if (busy_)
        reread_ = true;
    else
        read_folder();
}

void LibraryDialog::choose_folder() {
    const QString folder = QFileDialog::getExistingDirectory(this, Words::tr("Folder with cases"),
                                                             settings_.library_folder());
    if (folder.isEmpty()) return;
    settings_.set_library_folder(folder);
    read_folder();
}

void LibraryDialog::run(Doing doing, BackgroundJob::Work work) {
    job_.reset();
    messages_->dismiss();
    BackgroundJob::Callbacks callbacks;
    under_way_ = doing.under_way;
    callbacks.failed = [this, doing = std::move(doing)](const Failure& failure) {
        messages_->show_failure(failure);  // the main window's lies behind this one
        ways_.failed(doing.name, failure);
        if (!doing.copies) return;
        reread_ = true;  // some of it may be there
        failed_ = failure;
    };
    callbacks.ended = [this] {
        if (std::exchange(reread_, false))
            return QTimer::singleShot(0, this, [this] { read_folder(); });
        busy_ = false;
        show_chosen();
        if (!said_.isEmpty()) messages_->show_notice(std::exchange(said_, {}));
        if (failed_) messages_->show_failure(*std::exchange(failed_, std::nullopt));
        QTimer::singleShot(0, this, [this] { do_what_waits(); });
    };
    busy_ = true;
    show_chosen();
    job_ = std::make_unique<BackgroundJob>(std::move(work), std::move(callbacks));
}

void LibraryDialog::read_folder() {
    const fs::path folder = to_path(settings_.library_folder());
    folder_->setText(to_text(folder));
    if (const ShelvedCase* one = chosen()) chosen_ = one->place;
    cases_.clear();
    list_->clear();
    run({Words::tr("Read the library"), Words::tr("Reading the cases…")},
        [this, folder,
         recordings = to_path(settings_.recordings_folder())](Job& job) -> std::function<void()> {
            return [this, cases = cases_in(folder, recordings, job)] {
                cases_ = cases;
                fill();
            };
        });
}

void LibraryDialog::fill() {
    list_->clear();
    int row = cases_.empty() ? -1 : 0;
    for (const ShelvedCase& one : cases_) {
        // A folder NAME.hep and a file NAME.hepz beside it are told apart by their endings.
        const bool twin = std::ranges::count(cases_, one.name, &ShelvedCase::name) > 1;
        const QString name = twin ? to_text(one.place.filename()) : one.name;
        if (one.place == chosen_) row = list_->count();
        auto* item = new QListWidgetItem(name, list_);
        if (!one.drawing.isNull()) item->setIcon(untinted(QPixmap::fromImage(one.drawing)));
    }
    list_->setCurrentRow(row);
}

const ShelvedCase* LibraryDialog::chosen() const {
    const int row = list_->currentRow();
    return row >= 0 && row < static_cast<int>(cases_.size())
               ? &cases_[static_cast<std::size_t>(row)]
               : nullptr;
}

void LibraryDialog::show_chosen() {
    const ShelvedCase* one = chosen();
    open_->setEnabled(one != nullptr && one->readable && !busy_);
    give_->setEnabled(open_->isEnabled());
    take_->setEnabled(!busy_);
    choose_->setEnabled(!busy_);
    show_what_is_under_way();
    lessons_->setVisible(one != nullptr);
    lessons_->show_lessons(one != nullptr ? one->lessons : std::vector<ShelvedLesson>(),
                           open_->isEnabled());
    if (busy_ && one == nullptr) return facts_->setText(Words::tr("Reading the cases…"));
    facts_->setText(
        one != nullptr ? "<b>" + one->name.toHtmlEscaped() + "</b><br>" + one->facts
                       : Words::tr("There is no case in this folder. Choose another one, or save a "
                                   "patient here: File > Save case as."));
}

void LibraryDialog::show_what_is_under_way() {
    const QString said = busy_ ? under_way_ : QString();
    waits_->setText(said);
    const QString why =
        busy_ ? Words::tr("%1 These buttons wait for it.").arg(under_way_) : QString();
    for (QPushButton* button : {open_, give_, take_, choose_}) button->setToolTip(why);
}

void LibraryDialog::copy(const fs::path& from, const fs::path& to) {
    run({Words::tr("Copy the case"), Words::tr("Copying the case into this folder…"), true},
        [this, from, to](Job& job) -> std::function<void()> {
            job.begin_stage(Words::id("Copying the case"));
            const std::vector<Lesson> lessons = lessons_in_archive(from);
            write_case(to, read_case(from));
            return [this, said = what_came_with_it(put_beside(lessons, to))] {
                reread_ = true;
                said_ = said;
            };
        });
}

bool LibraryDialog::holds(const fs::path& place) const {
    std::error_code ignored;
    return is_case(place) && fs::equivalent(fs::absolute(place, ignored).parent_path(),
                                            to_path(settings_.library_folder()), ignored);
}

void LibraryDialog::choose_here(const fs::path& place) {
    const fs::path here = to_path(settings_.library_folder()) / place.filename();
    run({Words::tr("Import a case"), Words::tr("Reading the case…"), true},
        [this, here](Job& job) -> std::function<void()> {
            job.begin_stage(Words::id("Reading the case"));
            QStringList lines{Words::tr("“%1” lies in this folder already, and was not copied.")
                                  .arg(to_text(here.filename()))};
            if (const QString came =
                    what_came_with_it(put_beside(lessons_not_beside(here, job), here));
                !came.isEmpty())
                lines << came;
            return [this, here, said = lines.join("\n")] {
                list_->setCurrentRow(-1);  // otherwise reading would choose what is chosen now
                chosen_ = here;
                reread_ = true;
                said_ = said;
            };
        });
}

void LibraryDialog::give_away(const fs::path& to) {
    const ShelvedCase* one = chosen();
    if (one == nullptr || !one->readable) return;
    try {
        require_place_of_file(to);
    } catch (...) {
        const Failure failure = failure_of(std::current_exception());
        messages_->show_failure(failure);
        return ways_.failed(Words::tr("Copy the case"), failure);
    }
    ways_.copy_case(one->place, [this, from = one->place, to](bool lacks_work) {
        do_when_idle([this, from, to, lacks_work] { write_one_file(from, to, lacks_work); });
    });
}

void LibraryDialog::write_one_file(const fs::path& from, const fs::path& to, bool lacks_work) {
    const auto shelved = std::ranges::find(cases_, from, &ShelvedCase::place);
    if (shelved == cases_.end())
        return messages_->show_notice(
            Words::tr("“%1” was not copied: it does not lie in the folder that is shown any more.")
                .arg(to_text(from.filename())));
    std::vector<fs::path> files;
    for (const ShelvedLesson& lesson : shelved->lessons)
        if (lesson.patient == ShelvedLesson::Patient::this_case) files.push_back(lesson.file);
    run({Words::tr("Copy the case"), Words::tr("Writing the case into one file…"), true},
        [this, from, to, files, lacks_work](Job& job) -> std::function<void()> {
            job.begin_stage(Words::id("Copying the case"));
            std::vector<Lesson> lessons = lessons_not_beside(from, job);
            for (const fs::path& file : files) lessons.push_back(read_lesson(file));
            write_with_lessons(to, read_case(from), lessons);
            return [this, lacks_work, said = what_was_given(to, lessons.size())] {
                reread_ = true;
                said_ = said;
                if (lacks_work)
                    said_ += " " + Words::tr(
                                       "It lacks what is not saved yet: save the case, then "
                                       "copy it once more.");
            };
        });
}

void LibraryDialog::take_in(const fs::path& from) {
    if (holds(from)) return choose_here(from);
    const fs::path folder = to_path(settings_.library_folder()), name = from.stem();
    if (!is_taken(folder, name)) return copy(from, folder / fs::path(name).concat(".hep"));
    const fs::path other = free_name(folder, name);
    messages_->show_notice(
        Words::tr("There is a case “%1” here already; it was not replaced. Both can be kept, the "
                  "new one as “%2”.")
            .arg(to_text(name), to_text(other)),
        Words::tr("Keep both"),
        [this, from, to = folder / fs::path(other).concat(".hep")] { copy(from, to); });
}

}  // namespace hepatica
