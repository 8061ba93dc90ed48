// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/fake_window_test.h"

#include <chrono>
#include <thread>

#include "core/base/error.h"

namespace hepatica::testing {

FakeWindowTest::FakeWindowTest() : WindowTest(patients()) {}

MainWindow::Patients FakeWindowTest::patients() {
    MainWindow::Patients patients;
    patients.load = [this](const OpenRequest& request, Job& job) { return load(request, job); };
    patients.save = [this](const std::filesystem::path& path, const PatientCase&) {
        saved_ = path;
    };
    patients.archive = [this](const PatientCase&, const std::filesystem::path& ct,
                              const std::filesystem::path& file, Job&) {
        archived_ = {ct, file};
    };
    return patients;
}

LoadedPatient FakeWindowTest::load(const OpenRequest& request, Job& job) {
    if (request.built_in) return fake_patient(&simulation_);
    if (request.reconstruct.ct.filename() == "endless") {
        job.begin_stage("segment");
        for (endless_job_runs_ = true;;) {
            job.advance(0.3);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    throw InputError("this is no image", request.reconstruct.ct.string(), "give a CT");
}

void FakeWindowTest::open_built_in() {
    window_.actions()[ActionId::built_in].trigger();
    ASSERT_TRUE(wait_for([this] {
        return window_.has_patient() && !window_.busy() && simulation_->frame().step > 1;
    }));
    paint();
}

}  // namespace hepatica::testing
