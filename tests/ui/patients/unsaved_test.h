// SPDX-License-Identifier: GPL-3.0-or-later
// A test of what a program leaves of unsaved work, in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/opening/open_patient.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/fake_ward.h"
#include "ui/recovery.h"

namespace hepatica::testing {

class UnsavedTest : public ::testing::Test {
  protected:
    static constexpr int recovery_patience_ms = 60000;

    UnsavedTest() { need_event_loop(); }

    std::unique_ptr<Recovery> program(Recovery::Write write = write_case) {
        return std::make_unique<Recovery>(
            folder_, std::move(write),
            [this](const Failure& failure) { failures_.push_back(failure.problem); });
    }
    static OpenedPatient reconstructed(const std::string& title = "anton") {
        OpenedPatient opened;
        opened.title = title;
        opened.patient = test::small_patient();
        opened.worth_saving = true;
        return opened;
    }
    static bool rest(const Recovery& recovery) {
        return QTest::qWaitFor([&] { return recovery.resting(); }, recovery_patience_ms);
    }
    // As the next program sees it.
    std::vector<std::filesystem::path> seen_by_another() { return program()->left_behind(); }
    // All files, of whatever kind.
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> all;
        if (!std::filesystem::exists(folder_)) return all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
            if (entry.is_regular_file()) all.push_back(entry.path());
        return all;
    }

    QTemporaryDir temporary_;
    std::filesystem::path folder_ = std::filesystem::path(temporary_.path().toStdString()) / "kept";
    std::vector<std::string> failures_;
    Workspace workspace_;
};

}  // namespace hepatica::testing
