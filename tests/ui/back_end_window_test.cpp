// SPDX-License-Identifier: GPL-3.0-or-later
// The window that plays on a device, here the emulated one: which is chosen, shown, lost, missed.
#include <QComboBox>
#include <QSlider>
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/scene/measured_dial.h"
#include "tests/session/small_patient.h"
#include "tests/support/emulated_back_end.h"
#include "tests/ui/window_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

const std::string emulated = "emulated on the processor";

// "cuda" is the emulated device, and "auto" is, with the processor beside it; until it is taken
// away.
class Hardware {
  public:
    DeformBackEnd make(const std::string& name, const BackEnds::Say& say) {
        if (name == "cpu") return cpu_back_end();
        if (!there) throw InputError("this build has no CUDA", "the CUDA back end", "Build it");
        test::EmulatedBackEnd made = test::emulated_back_end(say);
        made.back_end.beside_processor = name == "auto";
        lose = made.lose;
        return made.back_end;
    }
    std::atomic<bool> there = true;
    std::function<void()> lose;  // of the last one made
};

std::shared_ptr<const PatientCase> patient_with_both() {
    auto patient = std::make_shared<PatientCase>(*test::small_patient());
    StepperOptions two;
    two.substeps = 2;
    patient->dial_json = dial_json(
        {{{}, 1.0, 0.2, "this body"}, {two, 2.0, 0.1, "this body", "cuda-emulated", emulated}},
        *patient);
    return patient;
}

class BackEndWindow : public testing::WindowTest {
  protected:
    BackEndWindow() : BackEndWindow(std::make_shared<Hardware>()) {}

    void choose(const char* name) {
        const int index = box_->findData(QString(name));
        ASSERT_GE(index, 0) << name;
        box_->setCurrentIndex(index);
        emit box_->activated(index);
    }
    bool device_shows(const QString& words) {
        return testing::wait_for([&] { return device_->text() == words; });
    }
    void pull() {
        const VesselTree& tree = test::small_patient()->tree;
        const QPoint start = on_widget(test::middle_of(tree, 0));
        QTest::mousePress(&window_.view(), Qt::LeftButton, {}, start);
        QTest::mouseMove(&window_.view(), start + QPoint(20, 0));
        QTest::mouseMove(&window_.view(), start + QPoint(30, 0));
    }

    std::shared_ptr<Hardware> hardware_;
    QComboBox* box_ = nullptr;
    QLabel* device_ = nullptr;

  private:
    static MainWindow::Patients patients(const std::shared_ptr<BackEnds>& back_ends) {
        MainWindow::Patients patients{[back_ends](const OpenRequest&, Job& job) {
                                          return play_with(back_ends->for_play(),
                                                           patient_with_both(), job);
                                      },
                                      write_case};
        patients.back_ends = back_ends;
        return patients;
    }
    explicit BackEndWindow(std::shared_ptr<Hardware> hardware)
        : WindowTest(patients(std::make_shared<BackEnds>(
              [hardware](const std::string& name, const BackEnds::Say& say) {
                  return hardware->make(name, say);
              }))),
          hardware_(std::move(hardware)),
          box_(window_.findChild<QComboBox*>("back_end")),
          device_(window_.findChild<QLabel*>("device")) {
        open_built_in();
    }
};

TEST_F(BackEndWindow, plays_on_what_was_chosen_says_so_and_remembers_it) {
    EXPECT_EQ(box_->currentData().toString(), "cpu");
    EXPECT_TRUE(device_shows("the processor"));
    EXPECT_EQ(settings_.back_end(), "cpu");
    choose("cuda");
    EXPECT_TRUE(device_shows("emulated on the processor"));
    EXPECT_EQ(window_.frame().statistics.device, emulated);
    EXPECT_EQ(settings_.back_end(), "cuda");
    EXPECT_EQ(Settings(folder_.filePath("settings.ini")).back_end(), "cuda");
    EXPECT_TRUE(window_.messages().text().startsWith("The device's steps leave out tension"))
        << window_.messages().text().toStdString();
    choose("cpu");
    EXPECT_TRUE(device_shows("the processor"));
}

TEST_F(BackEndWindow, dial_goes_from_the_processors_setting_to_the_devices) {
    choose("auto");
    auto& dial = *window_.findChild<QSlider*>("dial");
    dial.setValue(100);
    EXPECT_TRUE(device_shows("emulated on the processor"));
    dial.setValue(0);
    EXPECT_TRUE(device_shows("the processor"));
    EXPECT_TRUE(window_.frame().statistics.setting.ends_with("on the processor"));
    dial.setValue(100);
    EXPECT_TRUE(device_shows("emulated on the processor"));
}

TEST_F(BackEndWindow, without_a_device_says_why_and_goes_on_with_the_processor) {
    hardware_->there = false;
    choose("cuda");
    ASSERT_TRUE(testing::wait_for([&] { return !window_.messages().text().isEmpty(); }));
    EXPECT_TRUE(window_.messages().text().contains("this build has no CUDA. Build it"))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(device_shows("the processor"));
    EXPECT_EQ(window_.frame().statistics.device, "");
    EXPECT_FALSE(window_.frame().statistics.paused);
}

TEST_F(BackEndWindow, goes_on_with_the_processor_where_its_device_is_lost_and_says_so) {
    choose("cuda");
    ASSERT_TRUE(device_shows("emulated on the processor"));
    hardware_->lose();
    pull();
    ASSERT_TRUE(
        testing::wait_for([&] { return window_.messages().text().contains("the device failed"); }));
    EXPECT_TRUE(window_.messages().text().contains("The processor makes the steps"));
    EXPECT_TRUE(device_shows("the processor"));
    EXPECT_TRUE(testing::wait_for([&] { return window_.frame().grab.has_value(); }));
    EXPECT_FALSE(window_.frame().statistics.diverged);
}

}  // namespace
}  // namespace hepatica
