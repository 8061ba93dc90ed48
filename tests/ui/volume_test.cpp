// SPDX-License-Identifier: GPL-3.0-or-later
// The CT as a volume around the vessels: when it is read and forgotten, what it says where there is
// none, its bar, and what of it is remembered.
#include <QComboBox>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <limits>

#include "tests/ui/slices_test.h"
#include "ui/message_bar.h"
#include "ui/volume_keeper.h"

namespace hepatica::testing {
namespace {

class VolumeOfCt : public SlicesTest {
  protected:
    CtReadings readings_;
    VolumeKeeper keeper_{
        settings_,
        readings_,
        {[this](std::shared_ptr<const Volume> ct) { shown_ = std::move(ct); },
         [this] { return of_slices_; }, [this](const JobProgress&) { reads_ = true; },
         [this](const Failure& failure) { failed_ = failure.problem; }}};
    std::shared_ptr<const Volume> shown_, of_slices_;
    bool reads_ = false;
    std::string failed_;
};

TEST_F(VolumeOfCt, IsReadWhereItIsWantedAndForgottenWhereItIsNot) {
    keeper_.show_patient(patient_, {}, file_);
    EXPECT_FALSE(keeper_.making());
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return shown_ != nullptr; }));
    EXPECT_FALSE(shown_->voxels.empty());
    const std::weak_ptr<const Volume> kept = shown_;
    keeper_.set_wanted(false);
    EXPECT_EQ(shown_, nullptr);
    EXPECT_TRUE(wait_for([&] { return kept.expired(); }));
    // It is remembered where it lies.
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return shown_ != nullptr; }));
    EXPECT_EQ(failed_, "");
    // The next patient's is another.
    keeper_.show_patient(nullptr, {}, {});
    EXPECT_EQ(shown_, nullptr);
    EXPECT_FALSE(keeper_.making());
}

// Slices and volume, wanted at once.
TEST_F(VolumeOfCt, IsReadOnceForAllWhoWaitForIt) {
    std::vector<std::shared_ptr<const Volume>> found;
    CtKeeper::Screen screen;
    screen.found = [&](std::shared_ptr<const Volume> ct, const Mask&) { found.push_back(ct); };
    screen.progress = [](const JobProgress&) {};
    screen.failed = [](const Failure& failure) { ADD_FAILURE() << failure.problem; };
    CtKeeper first(settings_, readings_, screen), second(settings_, readings_, screen);
    for (CtKeeper* keeper : {&first, &second}) {
        keeper->show(patient_, {}, file_);
        keeper->want();
    }
    keeper_.show_patient(patient_, {}, file_);
    keeper_.set_wanted(true);
    keeper_.set_wanted(false);  // the others wait on
    ASSERT_TRUE(wait_for([&] { return !first.reading() && !second.reading(); }));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], found[1]);
    found.clear();
    first.read_from(file_);
    first.show(nullptr, {}, {});
    EXPECT_FALSE(first.reading());
    EXPECT_TRUE(readings_.present.expired()) << "nobody waits for it";
}

TEST_F(VolumeOfCt, IsCutOutOfWhatTheSlicesHaveRead) {
    std::filesystem::remove(file_);  // it could not be read again
    of_slices_ = std::make_shared<const Volume>(ct_);
    const std::weak_ptr<const Volume> whole = of_slices_;
    keeper_.show_patient(patient_, {}, {});
    keeper_.set_wanted(true);
    of_slices_.reset();
    ASSERT_TRUE(wait_for([this] { return shown_ != nullptr; }));
    EXPECT_TRUE(wait_for([&] { return whole.expired(); })) << "the whole CT is not kept";
}

TEST_F(VolumeOfCt, SaysWhatIsMissingAndTakesWhatIsChosen) {
    keeper_.show_patient(patient_, {}, {});
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return !failed_.empty(); }));
    EXPECT_EQ(failed_, "it is not known where this patient's CT lies");
    EXPECT_EQ(shown_, nullptr);
    keeper_.read_from(file_);
    EXPECT_TRUE(wait_for([this] { return shown_ != nullptr; }));
}

TEST_F(VolumeOfCt, SaysThatTheCtIsBesideThePatient) {
    auto elsewhere = std::make_shared<PatientCase>(*patient_);
    for (Vec3& point : elsewhere->tree.segments[0].points_mm) point += Vec3(0, 0, 5000);
    keeper_.show_patient(elsewhere, {}, file_);
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return !failed_.empty(); }));
    EXPECT_EQ(shown_, nullptr);
}

class VolumeInWindow : public SlicesTest {
  protected:
    QWidget& bar() { return *window_.findChild<QWidget*>("volumeBar"); }
    QAction& action() { return window_.actions()[ActionId::toggle_volume]; }
    void show_volume() {
        window_.volume().show_patient(patient_, {}, file_);
        QTest::keyClick(&window_, Qt::Key_V, Qt::ShiftModifier);
        ASSERT_TRUE(wait_for([this] { return bar().isEnabled(); }));
    }
};

TEST_F(VolumeInWindow, ComesAndGoesByItsKeyAndIsRemembered) {
    EXPECT_FALSE(action().isChecked());
    EXPECT_FALSE(bar().isVisible());
    const QImage without = window_.view().picture();
    show_volume();
    EXPECT_TRUE(bar().isVisible());
    EXPECT_TRUE(action().isChecked());
    EXPECT_TRUE(settings_.volume_shown());
    EXPECT_NE(window_.view().picture(), without);
    QTest::keyClick(&window_, Qt::Key_V, Qt::ShiftModifier);
    EXPECT_FALSE(bar().isVisible());
    EXPECT_FALSE(settings_.volume_shown());
    settings_.set_volume_shown(true);
    MainWindow next(settings_, {});
    EXPECT_TRUE(next.actions()[ActionId::toggle_volume].isChecked());
    EXPECT_TRUE(next.volume().wanted());
}

// The bar has its place from when the key is pressed: a CT that is read moves nothing.
TEST_F(VolumeInWindow, PushesThePicturesDownOnlyWithItsKey) {
    window_.volume().show_patient(patient_, {}, file_);
    QTest::keyClick(&window_, Qt::Key_V, Qt::ShiftModifier);
    EXPECT_TRUE(bar().isVisible());
    EXPECT_FALSE(bar().isEnabled());
    QApplication::processEvents();
    const QPoint before = views().mapToGlobal(QPoint());
    ASSERT_TRUE(wait_for([this] { return bar().isEnabled(); }));
    QApplication::processEvents();
    EXPECT_EQ(views().mapToGlobal(QPoint()), before);
}

// Of a large CT it takes several seconds.
TEST_F(VolumeInWindow, CanBeCancelledWhileItIsReadAndBegunAgain) {
    auto* cancel = window_.findChild<QPushButton*>("cancelVolume");
    EXPECT_FALSE(cancel->isVisible());
    window_.volume().show_patient(patient_, {}, file_);
    QTest::keyClick(&window_, Qt::Key_V, Qt::ShiftModifier);
    ASSERT_TRUE(cancel->isVisible());
    cancel->click();
    EXPECT_FALSE(window_.volume().making());
    EXPECT_FALSE(window_.volume().wanted());
    EXPECT_FALSE(action().isChecked());
    EXPECT_FALSE(bar().isVisible());
    show_volume();
    EXPECT_FALSE(cancel->isVisible()) << "it is there";
    EXPECT_TRUE(action().isChecked());
}

TEST_F(VolumeInWindow, LooksAsItsBarSays) {
    show_volume();
    const QImage first = window_.view().picture();
    auto* preset = bar().findChild<QComboBox*>("volumePreset");
    preset->setFocus();
    QTest::keyClick(preset, Qt::Key_Down);
    EXPECT_EQ(settings_.volume_look().preset, VolumePreset::maximum_intensity);
    const QImage maximum = window_.view().picture();
    EXPECT_NE(maximum, first);
    bar().findChild<QSlider*>("volumeDensity")->setValue(90);
    EXPECT_DOUBLE_EQ(settings_.volume_look().density, 0.9);
    EXPECT_NE(window_.view().picture(), maximum);
    MainWindow next(settings_, {});
    EXPECT_EQ(next.findChild<QComboBox*>("volumePreset")->currentIndex(), 1);
    EXPECT_EQ(next.findChild<QSlider*>("volumeDensity")->value(), 90);
}

TEST_F(VolumeInWindow, FollowsTheGreyWindowOfTheSlices) {
    show_volume();
    const QImage first = window_.view().picture();
    scene().set_window({5000.0, 10.0});  // everything is black
    EXPECT_NE(window_.view().picture(), first);
}

TEST_F(VolumeInWindow, SaysWhyThereIsNone) {
    QTest::keyClick(&window_, Qt::Key_V, Qt::ShiftModifier);
    ASSERT_TRUE(wait_for([this] { return window_.messages().isVisible(); }));
    EXPECT_TRUE(window_.messages().text().contains("not known where this patient's CT lies"))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(window_.messages().findChild<QPushButton*>("offer")->isVisible());
    EXPECT_FALSE(bar().isEnabled());
    EXPECT_FALSE(window_.findChild<QPushButton*>("cancelVolume")->isVisible());
}

TEST(VolumeSettings, AreKeptAndTakeNoNonsense) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("settings.ini");
    {
        Settings settings(file);
        EXPECT_FALSE(settings.volume_shown());
        EXPECT_EQ(settings.volume_look().preset, VolumePreset::vessels_and_bones);
        settings.set_volume_shown(true);
        settings.set_volume_look({VolumePreset::maximum_intensity, 0.25, {}});
    }
    EXPECT_TRUE(Settings(file).volume_shown());
    EXPECT_EQ(Settings(file).volume_look().preset, VolumePreset::maximum_intensity);
    EXPECT_DOUBLE_EQ(Settings(file).volume_look().density, 0.25);
    {
        QSettings store(file, QSettings::IniFormat);
        store.setValue("volume/preset", "something");
        store.setValue("volume/density", std::numeric_limits<double>::quiet_NaN());
    }
    EXPECT_EQ(Settings(file).volume_look().preset, VolumePreset::vessels_and_bones);
    EXPECT_DOUBLE_EQ(Settings(file).volume_look().density, 0.5);
    QSettings(file, QSettings::IniFormat).setValue("volume/density", 7.0);
    EXPECT_DOUBLE_EQ(Settings(file).volume_look().density, 1.0);
    Settings safe(Settings::Mode::safe);
    safe.set_volume_shown(true);
    EXPECT_FALSE(safe.volume_shown());
}

}  // namespace
}  // namespace hepatica::testing
