// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_wizard.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QVBoxLayout>
#include <cmath>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/patient_place.h"
#include "ui/series_dialog.h"
#include "ui/words.h"

namespace hepatica {

namespace {

void add_seeds(const QLineEdit& edit, const std::string& field, VascularSystem system,
               std::vector<VesselSeed>& seeds) {
    for (const QString& text : edit.text().split(';', Qt::SkipEmptyParts)) {
        if (text.trimmed().isEmpty()) continue;
        const std::optional<Vec3> place_mm = read_patient_place(text);
        if (!place_mm)
            throw InputError(
                Words::tr("“%1” is no place").arg(text.trimmed()).toStdString(), field,
                Words::id("write it as the slices do, as L 12 P 40 H 155 mm, and a semicolon "
                          "before the next one; or leave it empty"));
        seeds.push_back({*place_mm, system});
    }
}

// A placeholder says what belongs there, and cut off it does not.
void widen_to_placeholder(QLineEdit& edit) {
    const int text = edit.fontMetrics().horizontalAdvance(edit.placeholderText());
    QStyleOptionFrame frame;
    frame.initFrom(&edit);
    constexpr int beside_text = 2 * 4;
    const QSize whole = edit.style()->sizeFromContents(QStyle::CT_LineEdit, &frame,
                                                       QSize(text + beside_text, 0), &edit);
    edit.setMinimumWidth(whole.width());
}

}  // namespace

std::vector<double> numbers_in(const QString& text, const std::string& field) {
    std::vector<double> numbers;
    const QRegularExpression separators("[\\s;]+");
    for (const QString& part : text.split(separators, Qt::SkipEmptyParts)) {
        bool understood = false;
        const double number = QString(part).replace(',', '.').toDouble(&understood);
        if (!understood || !std::isfinite(number)) {
            throw InputError(Words::tr("“%1” is no number").arg(part).toStdString(), field,
                             Words::id("separate numbers by blanks or semicolons"));
        }
        numbers.push_back(number);
    }
    return numbers;
}

PatientWizard::PatientWizard(const QString& folder, QWidget* parent)
    : QDialog(parent),
      folder_(folder),
      form_(new QFormLayout),
      series_(new QComboBox(this)),
      problem_(new QLabel(this)) {
    setWindowTitle(Words::tr("Reconstruct a patient"));
    setMinimumWidth(560);
    auto* column = new QVBoxLayout(this);
    ct_ = add_path(*form_, Words::tr("CT (folder or file)"), true);
    ct_->setObjectName("ct");
    connect(ct_, &QLineEdit::editingFinished, this, [this] { look_for_series(); });
    series_->setObjectName("series");
    series_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    series_->setToolTip(Words::tr("Of the folder; the first shows the liver's vessels best"));
    form_->addRow(Words::tr("Series"), series_);
    offer({});
    liver_mask_ = add_path(*form_, Words::tr("Liver mask"), false);
    liver_mask_->setObjectName("liverMask");
    liver_mask_->setPlaceholderText(Words::tr("optional: speeds up and steadies the segmentation"));
    vessel_mask_ = add_path(*form_, Words::tr("Vessel mask"), false);
    vessel_mask_->setObjectName("vesselMask");
    vessel_mask_->setPlaceholderText(Words::tr("optional: replaces the segmentation"));
    tumour_masks_ = add_path(*form_, Words::tr("Tumour masks"), false);
    tumour_masks_->setObjectName("tumourMasks");
    tumour_masks_->setPlaceholderText(
        Words::tr("optional: targets of a drug; next file after a semicolon"));
    window_ = new QLineEdit(this);
    window_->setObjectName("window");
    window_->setPlaceholderText(
        Words::tr("optional: lowest and highest HU of the vessels, as 140 260"));
    form_->addRow(Words::tr("Window (HU)"), window_);
    for (const auto& [seeds, label] :
         {std::pair(&portal_seeds_, Words::tr("Portal vein seeds")),
          std::pair(&hepatic_seeds_, Words::tr("Hepatic vein seeds")),
          std::pair(&artery_seeds_, Words::tr("Hepatic artery seeds"))}) {
        *seeds = new QLineEdit(this);
        (*seeds)->setPlaceholderText(
            Words::tr("optional: a place as the slices write it, L 12 P 40 H 155 mm"));
        (*seeds)->setToolTip(
            Words::tr("A place in the vessel: to the left (L) or right (R), the back (P) or front "
                      "(A), the head (H) or feet (F), in mm, as it stands below the slices under "
                      "the pointer. A semicolon stands before the next one."));
        form_->addRow(label, *seeds);
    }
    portal_seeds_->setObjectName("portalSeeds");
    hepatic_seeds_->setObjectName("hepaticSeeds");
    artery_seeds_->setObjectName("arterySeeds");
    for (QLineEdit* edit : edits()) widen_to_placeholder(*edit);
    column->addLayout(form_);
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    column->addWidget(problem_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* go = buttons->addButton(Words::tr("Reconstruct"), QDialogButtonBox::AcceptRole);
    go->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        try {
            options();
            accept();
        } catch (const Error& error) {
            QString remedy = translated(error.remedy());
            if (!remedy.isEmpty()) remedy[0] = remedy[0].toUpper();
            problem_->setText(
                QString("%1: %2. %3")
                    .arg(translated(error.place()), translated(error.problem()), remedy));
        }
    });
    column->addWidget(buttons);
}

QLineEdit* PatientWizard::add_path(QFormLayout& form, const QString& label, bool folders_too) {
    auto* row = new QHBoxLayout;
    auto* edit = new QLineEdit(this);
    row->addWidget(edit, 1);
    const auto add_button = [&](const QString& text, bool folder) {
        auto* button = new QPushButton(text, this);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, edit, label, folder] {
            const QString chosen =
                folder ? QFileDialog::getExistingDirectory(this, label, folder_)
                       : QFileDialog::getOpenFileName(this, label, folder_, volume_filter());
            if (chosen.isEmpty()) return;
            edit->setText(chosen);
            emit edit->editingFinished();
        });
        row->addWidget(button);
    };
    if (folders_too) add_button(Words::tr("Folder…"), true);
    add_button(Words::tr("File…"), false);
    form.addRow(label, row);
    return edit;
}

PatientWizard::~PatientWizard() = default;

void PatientWizard::set_ct(const QString& path, int series) {
    ct_->setText(path);
    chosen_in_ = to_path(ct_->text().trimmed());
    chosen_ = series;
    look_for_series();
}

std::array<QLineEdit*, 8> PatientWizard::edits() const {
    return {ct_,     liver_mask_,   vessel_mask_,   tumour_masks_,
            window_, portal_seeds_, hepatic_seeds_, artery_seeds_};
}

void PatientWizard::set_seeds(const std::vector<VesselSeed>& seeds) {
    constexpr int decimals = 1;  // a voxel is hardly smaller
    for (const auto& [edit, system] : {std::pair(portal_seeds_, VascularSystem::portal),
                                       std::pair(hepatic_seeds_, VascularSystem::hepatic),
                                       std::pair(artery_seeds_, VascularSystem::artery)}) {
        QStringList places;
        for (const VesselSeed& seed : seeds)
            if (seed.system == system) places << patient_place(seed.position_mm, decimals);
        if (!places.isEmpty()) fill(*edit, places.join("; "));
    }
}

void PatientWizard::fill(QLineEdit& edit, const QString& text) {
    edit.setText(text);
    filled_.emplace_back(&edit, text);
    filled_for_ = ct_->text().trimmed();
}

void PatientWizard::forget_filled() {
    bool forgotten = false;
    filled_for_.reset();
    for (const auto& [edit, text] : std::exchange(filled_, {})) {
        if (edit->text() != text) continue;
        edit->clear();
        forgotten = true;
    }
    problem_->setText(forgotten ? Words::tr("Seeds and masks of the other CT were taken out.")
                                : QString());
}

void PatientWizard::set_given(const GivenParts& given, const Settings::MaskPlaces& known) {
    const bool anything = given.liver_mask || given.vessel_mask || given.tumour_masks > 0 ||
                          given.window_hu || !given.seeds.empty();
    if (anything && ct_->text().trimmed().isEmpty()) {
        problem_->setText(
            Words::tr("The present case was made with seeds, masks or a window. They "
                      "are offered here once it is known where its CT lies: choose "
                      "it in the slices (F7)."));
        return;
    }
    filled_for_ = ct_->text().trimmed();
    QStringList missing;
    const auto offer_mask = [&](bool was_given, QLineEdit& edit, const QString& place,
                                const QString& name) {
        if (!was_given) return;
        place.isEmpty() ? void(missing << name) : fill(edit, place);
    };
    offer_mask(given.liver_mask, *liver_mask_, known.liver, Words::tr("a liver mask"));
    offer_mask(given.vessel_mask, *vessel_mask_, known.vessel, Words::tr("a vessel mask"));
    const int tumours = static_cast<int>(given.tumour_masks);
    const bool knows_all = known.tumours.size() == tumours;
    offer_mask(tumours > 0, *tumour_masks_, knows_all ? known.tumours.join("; ") : QString(),
               Words::tr("%n tumour mask(s)", nullptr, tumours));
    if (given.window_hu)
        fill(*window_, QString("%1 %2").arg(given.window_hu->first).arg(given.window_hu->second));
    if (!missing.isEmpty())
        problem_->setText(Words::tr("The present case was made with %1, and it is not known where "
                                    "that lies. Choose it again, or the new case is without it.")
                              .arg(missing.join(", ")));
}

QStringList PatientWizard::entries() const {
    QStringList entries{QString::number(chosen_series())};
    for (const QLineEdit* edit : edits()) entries << edit->text();
    return entries;
}

void PatientWizard::set_entries(const QStringList& entries) {
    qsizetype next = 1;
    for (QLineEdit* edit : edits()) edit->setText(entries.value(next++));
    set_ct(ct_->text(), entries.value(0).toInt());
}

// While the folder is still looked through, the one that was named for it counts.
int PatientWizard::chosen_series() const {
    if (series_->count() > 1) return series_->currentIndex() + 1;
    const std::filesystem::path folder = to_path(ct_->text().trimmed());
    return listing_ && folder == looked_in_ && folder == chosen_in_ ? chosen_ : 0;
}

void PatientWizard::look_for_series() {
    const std::filesystem::path folder = to_path(ct_->text().trimmed());
    // The field tells so whenever it loses the focus: the series chosen then stays.
    if (std::exchange(looked_in_, folder) == folder) return;
    if (filled_for_ && ct_->text().trimmed() != *filled_for_) forget_filled();
    listing_.reset();
    offer({});
    std::error_code unreadable;  // then opening it will say why
    if (!std::filesystem::is_directory(folder, unreadable) || is_case(folder)) return;
    // Thousands of files take a while; a field that is not there yet would be missed.
    series_->setPlaceholderText(Words::tr("Looking through the folder…"));
    series_->setEnabled(false);
    form_->setRowVisible(series_, true);
    BackgroundJob::Callbacks callbacks;
    // Reading the CT will report the same.
    callbacks.failed = [this](const Failure&) { offer({}); };
    callbacks.ended = [this] { listing_.reset(); };
    listing_ = std::make_unique<BackgroundJob>(
        [this, folder](Job& job) -> std::function<void()> {
            return [this, folder, series = list_series(folder, job)] {
                offer(series);
                const bool named = folder == chosen_in_ && chosen_ <= series_->count();
                if (named && chosen_ > 0) series_->setCurrentIndex(chosen_ - 1);
            };
        },
        std::move(callbacks));
}

void PatientWizard::offer(const std::vector<SeriesDescription>& series) {
    series_->clear();
    series_->setEnabled(true);
    series_->setPlaceholderText({});  // with one, no series would be chosen
    for (const SeriesDescription& one : series) {
        QString text = Words::tr("%1: %2, %3 images")
                           .arg(QString::number(series_->count() + 1), name_in_list(one),
                                QString::number(one.slices));
        if (one.spacing_mm > 0.0)
            text += Words::tr(", %L1 mm apart").arg(one.spacing_mm, 0, 'g', 3);
        for (const std::string& word : {one.kernel, one.phase})
            if (!word.empty()) text += ", " + translated(word).replace("\\", ", ");
        series_->addItem(text);
        series_->setItemData(series_->count() - 1, why_not_first(one), Qt::ToolTipRole);
    }
    form_->setRowVisible(series_, series.size() > 1);
}

ReconstructOptions PatientWizard::options() const {
    ReconstructOptions options;
    if (ct_->text().trimmed().isEmpty()) {
        throw InputError(Words::id("nothing is chosen"), "CT",
                         Words::id("choose a DICOM folder or a volume file"));
    }
    options.ct = to_path(ct_->text().trimmed());
    options.series = chosen_series();
    for (const auto& [edit, mask] : {std::pair(liver_mask_, &options.liver_mask),
                                     std::pair(vessel_mask_, &options.vessel_mask)})
        if (const QString file = edit->text().trimmed(); !file.isEmpty()) *mask = to_path(file);
    for (const QString& file : tumour_masks_->text().split(';', Qt::SkipEmptyParts))
        if (!file.trimmed().isEmpty()) options.tumour_masks.push_back(to_path(file.trimmed()));
    const std::vector<double> window = numbers_in(window_->text(), Words::id("Window"));
    if (window.size() == 2 && window[0] < window[1]) {
        options.window_hu = {window[0], window[1]};
    } else if (!window.empty()) {
        throw InputError(Words::id("a window is two numbers, the lower one first"),
                         Words::id("Window"),
                         Words::id("write for example 140 260, or leave it empty"));
    }
    add_seeds(*portal_seeds_, Words::id("Portal vein seeds"), VascularSystem::portal,
              options.seeds);
    add_seeds(*hepatic_seeds_, Words::id("Hepatic vein seeds"), VascularSystem::hepatic,
              options.seeds);
    add_seeds(*artery_seeds_, Words::id("Hepatic artery seeds"), VascularSystem::artery,
              options.seeds);
    return options;
}

}  // namespace hepatica
