// SPDX-License-Identifier: GPL-3.0-or-later
// An instructor's whole way in the window itself, with real cases on a real disk: open, correct,
// save, close, open, in any order and without waiting. tests/ui/patients does the same a hundred
// times over without bodies; here it is the clicks, the files and the title bar that count.
#include <QComboBox>
#include <random>

#include "tests/patient/parted_patient.h"
#include "tests/ui/window_test.h"
#include "ui/message_bar.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class AnyClicks : public testing::WindowTest, public ::testing::WithParamInterface<int> {
  protected:
    AnyClicks() : WindowTest({testing::load_for_processor, write_case}) {
        const PatientCase patient = test::patient_with_bridges();
        for (const char* name : {"a.hep", "b.hep"}) write_case(path(name), patient);
        window_.open(folder_.filePath("a.hep"));
        wait();
        window_.actions()[ActionId::edit_mode].trigger();
    }

    fs::path path(const char* name) { return to_path(folder_.filePath(name)); }
    int pick(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
    const char* some_case() { return std::array{"a.hep", "b.hep", "c.hep"}.at(pick(3)); }

    void click_somewhere() {
        window_.findChild<QComboBox*>("EditTool")->setCurrentIndex(pick(3) == 0 ? 2 : 0);
        const std::array places{test::last_gap[1], Vec3(-8.6, 28, 4.4), Vec3(37, 54.5, 4),
                                Vec3(4.5, 26, 2), Vec3(0, 10, 1.5)};
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(places.at(pick(5))));
    }

    void do_something() {
        unsaved_answer_ =
            std::array{UnsavedAnswer::save, UnsavedAnswer::discard, UnsavedAnswer::cancel}.at(
                pick(3));
        save_place_ = path(some_case());
        switch (pick(9)) {
            case 0:
            case 1:
            case 2:
                return click_somewhere();
            case 3:
                return window_.actions()[ActionId::undo_edit].trigger();
            case 4:
                return window_.actions()[ActionId::redo_edit].trigger();
            case 5:
                return window_.actions()[ActionId::save_case].trigger();
            case 6:
                return window_.actions()[ActionId::save_case_as].trigger();
            case 7: {
                const char* name = some_case();
                if (fs::exists(path(name))) window_.open(folder_.filePath(name));
                return;
            }
            default:
                return wait();
        }
    }

    std::mt19937 random_{static_cast<unsigned>(GetParam())};
};

TEST_P(AnyClicks, end_with_screen_title_and_disk_in_agreement) {
    for (int click = 0; click < 14; ++click) {
        do_something();
        for (int turns = pick(40); turns > 0; --turns) QApplication::processEvents();
    }
    wait();
    const Workspace& workspace = window_.workspace();
    EXPECT_FALSE(workspace.awaits_body());
    EXPECT_EQ(window_.isWindowModified(), workspace.dirty());
    EXPECT_TRUE(window_.windowTitle().startsWith(to_text(workspace.folder().filename())));
    // Nothing is said to be saved that is not, whole and readable.
    const PatientCase on_disk = read_case(workspace.folder());
    EXPECT_EQ(on_disk.corrections.edits == workspace.edits(), !workspace.dirty());
    for (const char* name : {"a.hep", "b.hep"}) EXPECT_NO_THROW(read_case(path(name))) << name;

    // And it can be left with all there is.
    unsaved_answer_ = UnsavedAnswer::save;
    const Workspace::Edits wanted = workspace.edits();
    window_.close();
    ASSERT_TRUE(testing::wait_for([this] { return !window_.isVisible(); }));
    const PatientCase left = read_case(workspace.folder());
    EXPECT_EQ(left.corrections.edits, wanted);
    EXPECT_EQ(hash_of(left), hash_of(*workspace.patient()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyClicks, ::testing::Range(1, 5));

}  // namespace
}  // namespace hepatica
