// SPDX-License-Identifier: GPL-3.0-or-later
// A test of the whole window with a fake simulation behind it, which keeps every command.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <vector>

#include "tests/ui/fake_simulation.h"
#include "tests/ui/window_test.h"

namespace hepatica::testing {

class FakeWindowTest : public WindowTest {
  protected:
    FakeWindowTest();

    MainWindow::Patients patients();
    // The built-in patient is the fake one; a path ending in "endless" loads until it is cancelled;
    // every other path is refused.
    LoadedPatient load(const OpenRequest& request, Job& job);
    void open_built_in();

    template <class T>
    std::vector<T> commands_of_type() const {
        std::vector<T> found;
        for (const Command& command : simulation_->commands()) {
            if (const T* one = std::get_if<T>(&command)) found.push_back(*one);
        }
        return found;
    }

    // A place on the fake tree's trunk, whose centreline runs along z from -60 to -15 mm.
    static constexpr int half_way_up_the_trunk_mm = -40;
    QPoint on_trunk() { return on_widget(Vec3(0, 0, half_way_up_the_trunk_mm)); }

    FakeSimulation* simulation_ = nullptr;
    std::filesystem::path saved_;
    std::array<std::filesystem::path, 2> archived_;  // the CT's folder, the file
    std::atomic<bool> endless_job_runs_ = false;
};

}  // namespace hepatica::testing
