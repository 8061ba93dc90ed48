// SPDX-License-Identifier: GPL-3.0-or-later
// The form of a reconstruction offers again what the shown case was made with.
#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <filesystem>
#include <functional>

#include "core/reconstruction/reconstruct_parameters.h"
#include "tests/ui/fake_window_test.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class GivenAgain : public ::testing::Test {
  protected:
    QLineEdit& field(const char* name) { return *wizard_.findChild<QLineEdit*>(name); }

    PatientWizard wizard_{"/"};
};

TEST_F(GivenAgain, names_masks_of_the_case_whose_place_is_not_known) {
    GivenParts given;
    given.liver_mask = true;
    given.tumour_masks = 2;
    given.window_hu = {120.0, 300.5};
    const auto problem = [this] { return wizard_.findChild<QLabel*>("problem")->text(); };
    wizard_.set_given(given, {"/liver.nii", "", {"/only one.nii"}});
    EXPECT_TRUE(problem().contains("once it is known where its CT lies"))
        << problem().toStdString();
    EXPECT_EQ(field("liverMask").text(), "") << "whose CT may be another";
    wizard_.set_ct("/no such/ct");
    wizard_.set_given(given, {"/liver.nii", "", {"/only one.nii"}});
    EXPECT_EQ(field("liverMask").text(), "/liver.nii");
    EXPECT_EQ(field("window").text(), "120 300.5");
    EXPECT_EQ(field("tumourMasks").text(), "");
    EXPECT_TRUE(problem().contains("2 tumour mask")) << problem().toStdString();
    EXPECT_FALSE(problem().contains("liver mask")) << problem().toStdString();
    wizard_.set_given(given, {"/liver.nii", "", {"/one.nii", "/two.nii"}});
    EXPECT_EQ(wizard_.options().tumour_masks, (std::vector<fs::path>{"/one.nii", "/two.nii"}));
}

TEST_F(GivenAgain, takes_out_what_was_filled_in_for_another_ct) {
    wizard_.set_ct("/no such/ct");
    GivenParts given;
    given.liver_mask = true;
    given.window_hu = {120.0, 300.0};
    wizard_.set_given(given, {"/liver.nii", "", {}});
    wizard_.set_seeds({{Vec3(1, 2, 3), VascularSystem::portal}});
    field("window").setText("130 310");
    field("ct").setText("/no such/other");
    emit field("ct").editingFinished();
    EXPECT_EQ(field("liverMask").text(), "");
    EXPECT_EQ(field("portalSeeds").text(), "");
    EXPECT_EQ(field("window").text(), "130 310") << "it was typed";
    EXPECT_TRUE(wizard_.findChild<QLabel*>("problem")->text().contains("were taken out"));
}

// A case that was made with a seed, two tumour masks and a CT that is known.
class MadeWithSeeds : public testing::WindowTest {
  protected:
    MadeWithSeeds()
        : WindowTest({[](const OpenRequest&, Job&) {
                          LoadedPatient loaded = testing::fake_patient();
                          PatientCase patient = *loaded.patient;
                          patient.source.image_sha256 = std::string(64, 'a');
                          ReconstructOptions options;
                          options.seeds = {seed};
                          options.tumour_masks = {"one", "two"};
                          patient.source.parameters_json = parameters_json(options);
                          loaded.title = "made with seeds";
                          loaded.patient = std::make_shared<const PatientCase>(patient);
                          return loaded;
                      },
                      [](const fs::path&, const PatientCase&) {}}) {
        settings_.remember_image(std::string(64, 'a'), folder_.path());
        window_.open(folder_.path());
        wait();
    }
    // What the form of a reconstruction holds, and then does.
    ReconstructOptions form(const std::function<void(PatientWizard&)>& act = {}) {
        ReconstructOptions options;
        QTimer::singleShot(0, &window_, [&] {
            auto& wizard = dynamic_cast<PatientWizard&>(*QApplication::activeModalWidget());
            problem_ = wizard.findChild<QLabel*>("problem")->text();
            options = wizard.options();
            if (act) act(wizard);
            wizard.isVisible() ? wizard.reject() : void();
        });
        window_.actions()[ActionId::reconstruct].trigger();
        return options;
    }
    SeedMarks& marks() { return window_.view_layout().slices().seeds(); }

    static inline const VesselSeed seed{Vec3(1, 2, 3), VascularSystem::portal};
    QString problem_;
};

TEST_F(MadeWithSeeds, offers_them_again_for_the_next_reconstruction) {
    EXPECT_EQ(marks().seeds(), std::vector{seed}) << "drawn in the slices";
    EXPECT_EQ(form().seeds, std::vector{seed});
    EXPECT_TRUE(problem_.contains("2 tumour mask")) << problem_.toStdString();
    marks().take(VascularSystem::hepatic);
    marks().add(Vec3(4, 5, 6));
    EXPECT_EQ(form().seeds.size(), 2u) << "one more than before";
    marks().remove_last();
    marks().remove_last();
    EXPECT_TRUE(form().seeds.empty()) << "they were taken back";
}

TEST_F(MadeWithSeeds, knows_its_masks_after_it_was_made_here) {
    const QString one = folder_.filePath("one.nii"), two = folder_.filePath("two.nii");
    form([&](PatientWizard& wizard) {
        wizard.findChild<QLineEdit*>("tumourMasks")->setText(one + "; " + two);
        wizard.accept();
    });
    wait();
    EXPECT_EQ(settings_.places_of_masks(std::string(64, 'a')).tumours, (QStringList{one, two}));
    EXPECT_EQ(form().tumour_masks, (std::vector<fs::path>{to_path(one), to_path(two)}));
    EXPECT_EQ(problem_, "");
}

}  // namespace
}  // namespace hepatica
