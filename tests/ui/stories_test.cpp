// SPDX-License-Identifier: GPL-3.0-or-later
// Two whole stories, by mouse and keys: an instructor makes a lesson of a CT that nobody has seen,
// a trainee plays it to the report. Patients, files, simulation and report are the program's own.
// Every wait is for something to come true.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>
#include <filesystem>

#include "core/image/volume_writer.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/patient/patient_case.h"
#include "core/phantom/phantom.h"
#include "core/tree/station.h"
#include "tests/ui/window_test.h"
#include "ui/attempts_dialog.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/review_dock.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::wait_for;

class Story : public testing::WindowTest {
  protected:
    Story() : WindowTest({testing::load_for_processor, write_case}) {
        window_.set_report_program(HEPATICA_PROGRAM);
        QObject::connect(&answering_, &QTimer::timeout, [this] { answer_file_dialog(); });
        answering_.start(20);
    }

    // A person types a name into the dialog that asks for one.
    void answer_file_dialog() {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr || file_to_name_.isEmpty()) return;
        dialog->findChild<QLineEdit*>()->setText(file_to_name_);
        file_to_name_.clear();
        QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    }
    QAction& menu_entry(const QString& menu, const QString& start) {
        for (const QAction* one : window_.menuBar()->actions())
            if (one->text().remove('&') == menu)
                for (QAction* entry : one->menu()->actions())
                    if (entry->text().remove('&').startsWith(start)) return *entry;
        throw std::runtime_error("there is no " + start.toStdString());
    }
    void wait_for_patient() {
        // A reconstruction takes its time where a computer builds at the same time.
        for (int patience = 0; patience < 4 && !(window_.has_patient() && !window_.busy());
             ++patience)
            wait_for([this] { return window_.has_patient() && !window_.busy(); });
        wait();
    }
    const VesselTree& tree() const { return window_.workspace().patient()->tree; }
    // In the middle of the longest branch at whose end nothing hangs.
    Vec3 on_an_end_branch() const {
        Vec3 place = Vec3::Zero();
        double longest = 0.0;
        for (const VesselSegment& branch : tree().segments) {
            const bool is_end =
                std::ranges::none_of(tree().segments, [&](const VesselSegment& other) {
                    return other.proximal_node == branch.distal_node;
                });
            const double length = length_mm(branch);
            if (!is_end || length < longest) continue;
            longest = length;
            place = station_at(branch, 0.5 * length).position_mm;
        }
        return place;
    }
    LessonEditor& editor() { return window_.lesson_editor(); }
    template <class Widget>
    Widget& of_editor(const char* name) {
        return *editor().findChild<Widget*>(name);
    }
    QString said(const char* name) { return window_.lessons().findChild<QLabel*>(name)->text(); }
    void click_of_lesson(const char* name) {
        QTest::mouseClick(window_.lessons().findChild<QPushButton*>(name), Qt::LeftButton);
    }

    QTimer answering_;
    QString file_to_name_;
};

TEST_F(Story, an_instructor_makes_a_lesson_of_a_ct_that_is_dropped) {
    const QString ct = folder_.filePath("anton.nii.gz");
    {
        Job job;
        write_nifti(to_path(ct), make_phantom({}, job).ct);
    }
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(ct)});
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    static_cast<QObject&>(window_).event(&drop);
    wait_for_patient();
    ASSERT_TRUE(window_.workspace().unsaved()) << "a reconstruction is worth a question";

    // The CT lies beside the vessels, and a click on a vessel leads the crosshair there.
    QTest::keyClick(&window_, Qt::Key_F7);
    SliceScene& slices = window_.view_layout().slices();
    ASSERT_TRUE(wait_for([&] { return !slices.empty(); }));
    QTest::keyClick(&window_, Qt::Key_F7);

    // A branch that is none is deleted, brought back, and deleted again.
    const std::size_t branches = tree().segments.size();
    window_.actions()[ActionId::edit_mode].trigger();
    auto& tool = *window_.findChild<QComboBox*>("EditTool");
    tool.setCurrentIndex(tool.findText("Delete a branch", Qt::MatchStartsWith));
    ASSERT_GE(tool.currentIndex(), 0);
    paint();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(on_an_end_branch()));
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    wait_for_patient();
    EXPECT_LT(tree().segments.size(), branches);
    window_.actions()[ActionId::undo_edit].trigger();
    wait_for_patient();
    EXPECT_EQ(tree().segments.size(), branches);
    window_.actions()[ActionId::redo_edit].trigger();
    wait_for_patient();
    EXPECT_LT(tree().segments.size(), branches);

    // The case is called as the CT.
    save_place_ = to_path(folder_.filePath("anton.hep"));
    window_.actions()[ActionId::save_case].trigger();
    ASSERT_TRUE(wait_for([this] { return !window_.busy(); }));
    EXPECT_EQ(proposed_place_.filename(), "anton.hep");
    EXPECT_FALSE(window_.workspace().unsaved());
    EXPECT_EQ(read_case(*save_place_).corrections.edits.size(), 1u);

    // A lesson on this patient, its mark set by a click.
    menu_entry("Lesson", "Edit lessons").trigger();
    of_editor<QLineEdit>("lessonName").setText("Pull Anton's vessel");
    auto& patient = of_editor<QComboBox>("lessonPatient");
    for (int i = 0; i < patient.count(); ++i)
        if (patient.itemText(i).contains("anton")) patient.setCurrentIndex(i);
    emit patient.activated(patient.currentIndex());
    of_editor<QTabWidget>("lessonPages").setCurrentIndex(1);
    of_editor<QPushButton>("mark0click").click();
    const Vec3 mark = on_an_end_branch();
    paint();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    ASSERT_TRUE(editor().document().lesson().marks[0].place.point_mm);
    file_to_name_ = folder_.filePath("lesson.json");
    of_editor<QPushButton>("lessonSave").click();
    ASSERT_FALSE(editor().document().dirty());
    editor().hide();
    const Lesson made = read_lesson(to_path(folder_.filePath("lesson.json")));
    EXPECT_EQ(made.patient, "anton.hep") << "they lie beside each other and can move together";

    // It can be played at once.
    file_to_name_ = folder_.filePath("lesson.json");
    menu_entry("Lesson", "Open lesson").trigger();
    ASSERT_TRUE(wait_for([this] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_TRUE(said("lessonTitle").contains("Pull Anton"));
    EXPECT_EQ(questions_asked_, 0) << "nothing was unsaved when he was opened again";
}

TEST_F(Story, a_trainee_plays_a_lesson_to_its_report) {
    menu_entry("Lesson", "2").trigger();  // a gentle pull, on the built-in patient
    for (int patience = 0; patience < 4 && !window_.lessons().playing(); ++patience)
        wait_for([this] { return window_.lessons().playing(); });
    ASSERT_TRUE(wait_for([this] { return window_.lessons().playing() && !window_.busy(); }));
    paint();
    window_.lessons().findChild<QLineEdit*>("lessonName")->setText("Berta");
    emit window_.lessons().findChild<QLineEdit*>("lessonName")->editingFinished();

    // Takes the vessel at the mark, leads it 12 mm aside little by little, holds it, lets it go.
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    const ViewAxes axes = window_.view().scene().axes();
    const Vec3 aside = (axes.up - axes.right).normalized();
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    ASSERT_TRUE(wait_for([&] { return said("lessonStep").startsWith("Step 2"); }));
    QPoint at = on_widget(mark);
    for (int step = 1; step <= 60; ++step) {
        at = on_widget(mark + 0.2 * step * aside);
        QTest::mouseMove(&window_.view(), at);
        paint();
    }
    ASSERT_TRUE(wait_for([&] { return said("lessonStep").startsWith("Step 3"); }))
        << said("lessonStep").toStdString() << said("lessonEnd").toStdString();
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, at);
    ASSERT_TRUE(wait_for([&] { return said("lessonEnd").contains("assed"); }));
    EXPECT_TRUE(said("lessonEnd").contains("Passed")) << said("lessonEnd").toStdString();
    ASSERT_TRUE(wait_for([this] { return window_.lessons().recorded(); }));

    // The report has its page, its PDF and the recording.
    file_to_name_ = folder_.path();
    click_of_lesson("lessonReport");
    for (int patience = 0; patience < 12 && window_.busy(); ++patience)
        wait_for([this] { return !window_.busy(); });
    ASSERT_TRUE(window_.messages().text().startsWith("The report is in"))
        << window_.messages().text().toStdString();
    int pages = 0;
    for (const auto& entry : fs::recursive_directory_iterator(to_path(folder_.path())))
        if (entry.path().extension() == ".html" || entry.path().extension() == ".pdf") {
            EXPECT_GT(entry.file_size(), 1000u) << entry.path();
            ++pages;
        }
    EXPECT_EQ(pages, 2);

    // The attempt stands in the learning curve under the name, and is looked back upon.
    click_of_lesson("lessonAttempts");
    AttemptsDialog& attempts = window_.lessons().attempts();
    ASSERT_EQ(attempts.attempts().size(), 1u);
    EXPECT_TRUE(attempts.attempts()[0].passed);
    EXPECT_EQ(attempts.attempts()[0].name, "Berta");
    attempts.findChild<QPushButton*>("attemptsLookBack")->click();
    ASSERT_TRUE(wait_for([this] { return window_.review().complete(); }));
}

}  // namespace
}  // namespace hepatica
