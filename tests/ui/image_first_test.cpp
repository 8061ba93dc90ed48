// SPDX-License-Identifier: GPL-3.0-or-later
// A CT can be looked at while its vessels are looked for.
#include <QTimer>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "tests/session/small_patient.h"
#include "tests/support/tube_ct.h"
#include "tests/ui/window_test.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

using testing::wait_for;

class ImageFirst : public testing::WindowTest {
  protected:
    // The image is read at once; the vessels are found when the test says so, or never.
    ImageFirst()
        : WindowTest({[this](const OpenRequest& request, Job& job) {
                          request.image_read(std::make_shared<const Volume>(test::tube_ct()));
                          read_ = true;
                          job.begin_stage("Finding the vessels");
                          while (!found_) {
                              job.throw_if_cancelled();
                              std::this_thread::sleep_for(std::chrono::milliseconds(1));
                          }
                          if (fails_) throw InputError("no vessels were found", "ct", "");
                          return play(test::small_patient(), job);
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {}

    ViewLayout& layout() { return window_.view_layout(); }
    bool shows_slices() {
        return !layout().slices().empty() && layout().slice_view(SliceDirection::axial).isVisible();
    }

    std::atomic<bool> read_{false}, found_{false}, fails_{false};
};

TEST_F(ImageFirst, is_seen_until_the_patient_is_there) {
    window_.open(folder_.filePath("ct"));
    ASSERT_TRUE(wait_for([&] { return shows_slices(); }));
    EXPECT_TRUE(window_.busy());
    EXPECT_FALSE(window_.has_patient());
    const QWidget* welcome = window_.findChild<QWidget*>("welcome");
    EXPECT_FALSE(welcome->isVisible()) << "its quarter of the window is too small for it";
    EXPECT_GE(layout().slices().ct().voxels.size(), 96u * 60u * 12u);
    found_ = true;
    wait();
    EXPECT_FALSE(layout().slices_visible()) << "they came by themselves, and go again";
}

TEST_F(ImageFirst, stays_where_the_slices_were_wanted_before) {
    window_.actions()[ActionId::toggle_slices].trigger();
    window_.open(folder_.filePath("ct"));
    ASSERT_TRUE(wait_for([&] { return shows_slices(); }));
    found_ = true;
    wait();
    EXPECT_TRUE(layout().slices_visible());
}

TEST_F(ImageFirst, goes_where_it_comes_to_nothing) {
    fails_ = true;
    window_.open(folder_.filePath("ct"));
    ASSERT_TRUE(wait_for([&] { return shows_slices(); }));
    found_ = true;
    ASSERT_TRUE(wait_for([&] { return !window_.busy(); }));
    EXPECT_TRUE(layout().slices().empty());
    EXPECT_FALSE(layout().slices_visible());
    EXPECT_TRUE(window_.findChild<QWidget*>("welcome")->isVisible());
}

// What is done in slices is done to who is shown, whoever is on his way.
TEST_F(ImageFirst, does_not_come_beside_another_patient) {
    found_ = true;
    open_built_in();
    found_ = read_ = false;
    const auto expect_no_slices = [this] {
        EXPECT_FALSE(shows_slices());
        EXPECT_FALSE(layout().slices_visible());
        EXPECT_FALSE(window_.actions()[ActionId::toggle_slices].isChecked());
    };
    window_.open(folder_.filePath("ct"));
    // The image was handed over before: what is posted then comes behind it.
    ASSERT_TRUE(wait_for([&] { return read_.load(); }));
    bool handled = false;
    QTimer::singleShot(0, &window_, [&handled] { handled = true; });
    ASSERT_TRUE(wait_for([&] { return handled; }));
    QCoreApplication::processEvents();
    EXPECT_TRUE(window_.busy());
    expect_no_slices();
    found_ = true;
    wait();
    expect_no_slices();
}

}  // namespace
}  // namespace hepatica
