// SPDX-License-Identifier: GPL-3.0-or-later
// A window whose patient is corrected as a person does it: by clicks in the view and in slices.
#pragma once

#include <QComboBox>
#include <QPushButton>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/image/volume_writer.h"
#include "core/patient/image_digest.h"
#include "tests/patient/parted_patient.h"
#include "tests/support/tube_ct.h"
#include "tests/ui/window_test.h"
#include "ui/paths.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica::testing {

// Hears what is posted to a simulation.
class Overheard : public Simulation {
  public:
    Overheard(std::unique_ptr<Simulation> played, std::vector<Command>& heard)
        : played_(std::move(played)), heard_(heard) {}
    void post(Command command) override {
        heard_.push_back(command);
        played_->post(std::move(command));
    }
    void on_frame(std::function<void()> tell) override { played_->on_frame(std::move(tell)); }
    bool update_frame() override { return played_->update_frame(); }
    const Frame& frame() const override { return played_->frame(); }

  private:
    std::unique_ptr<Simulation> played_;
    std::vector<Command>& heard_;
};

class EditingWindow : public WindowTest {
  protected:
    EditingWindow()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          if (!request.built_in) return load_patient(request, job);
                          return play(
                              std::make_shared<const PatientCase>(test::patient_with_bridges()),
                              job);
                      },
                      [this](const std::filesystem::path& path, const PatientCase& patient) {
                          write_case(path, patient);
                          saved_ = patient;
                      },
                      [this](std::shared_ptr<const PatientCase> patient, Job& job) {
                          LoadedPatient loaded = play(std::move(patient), job);
                          loaded.simulation =
                              std::make_unique<Overheard>(std::move(loaded.simulation), heard_);
                          return loaded;
                      }}) {
        open_built_in();
    }

    void click(const Vec3& point_mm) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(point_mm));
        wait();
    }
    // Of this CT, as if the patient had been reconstructed from it.
    void show_slices(const Volume& ct) {
        const auto file = to_path(folder_.filePath("ct.nii.gz"));
        write_nifti(file, ct);
        auto shown = std::make_shared<PatientCase>(*window_.workspace().patient());
        shown->source.image_sha256 = digest_of(ct);
        shown->source.image_grid = ct.grid;
        ViewLayout& views = window_.view_layout();
        views.show_patient(shown, {}, file);
        window_.actions()[ActionId::toggle_slices].trigger();
        ASSERT_TRUE(wait_for([&] { return !views.slices().empty(); }));
    }
    // Clicks along the vessel of tube_ct() in the axial slice, to be drawn.
    // From this share of its length on; it begins in the trunk.
    void point_out_the_tube(double from = 0.0) {
        const Vec3 end = test::tube_end_mm;
        const Vec3 begin = test::tube_begin_mm + from * (end - test::tube_begin_mm);
        show_slices(test::tube_ct());
        window_.view_layout().slices().set_crosshair(begin);
        emit child<QComboBox>("measure").activated(4);
        SliceView& axial = window_.view_layout().slice_view(SliceDirection::axial);
        for (const Vec3& place : {begin, Vec3(0.5 * (begin + end)), end})
            QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.place_of(place).toPoint());
    }
    // What would be written now.
    const PatientCase& saved() {
        window_.save_case(folder_.filePath("p.hep"));
        wait();
        return saved_;
    }
    // What is offered, which is worked out on another thread.
    void take_all() {
        const std::size_t before = window_.workspace().edits().size();
        child<QPushButton>("acceptAll").click();
        ASSERT_TRUE(wait_for([&] { return window_.workspace().edits().size() > before; }));
        wait();
    }
    void choose_tool(const QString& name) {
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        ASSERT_NE(tools, nullptr);
        ASSERT_GE(tools->findText(name), 0);
        tools->setCurrentIndex(tools->findText(name));
    }

    template <class T>
    T& child(const char* name) {
        T* found = window_.findChild<T*>(name);
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
        return *found;
    }
    // The last command of this kind that a corrected patient's simulation was given.
    template <class T>
    std::optional<T> heard() const {
        std::optional<T> last;
        for (const Command& command : heard_)
            if (const T* one = std::get_if<T>(&command)) last = *one;
        return last;
    }

    PatientCase saved_;
    std::vector<Command> heard_;
};

}  // namespace hepatica::testing
