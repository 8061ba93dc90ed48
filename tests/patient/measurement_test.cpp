// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured, as a case keeps it.
#include "core/patient/measurement.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/patient/case_header.h"
#include "tests/patient/some_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

const std::vector<KeptMeasurement> measured{
    {MeasurementKind::distance, {Vec3(1.25, -2, 1.0 / 3.0), Vec3(0, 0, 0)}},
    {MeasurementKind::angle, {Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 1e-3)}},
    {MeasurementKind::diameter, {Vec3(0, 0, 1), Vec3(0, 0, 9)}, 0.3125},
    {MeasurementKind::diameter, {Vec3(0, 0, 1), Vec3(0, 0, 9)}},
};

TEST(KeptMeasurements, AreTheSameAfterBeingWrittenAndRead) {
    EXPECT_EQ(measurements_from_json(measurements_to_json(measured), "a file"), measured);
}

// What is said of a file with this one measurement.
std::string refusal(const std::string& measurement) {
    try {
        measurements_from_json(
            R"({"format": "hepatica-measurements", "version": 1, "measurements": [)" + measurement +
                "]}",
            "p.hep/measurements.json");
    } catch (const InputError& error) {
        return error.place() + ": " + error.problem() + ". " + error.remedy();
    }
    return "";
}

TEST(KeptMeasurements, AreRefusedWithFileValueAndRemedy) {
    EXPECT_EQ(refusal(R"({"kind": "angle", "points_mm": [[0, 0, 0], [1, 0, 0], [1, 1, 0]]})"), "");
    const auto says = [](const std::string& measurement, const std::string& what) {
        const std::string said = refusal(measurement);
        EXPECT_TRUE(said.starts_with("p.hep/measurements.json")) << said;
        EXPECT_NE(said.find(what), std::string::npos) << said;
        EXPECT_NE(said.find("remove the file"), std::string::npos) << said;
    };
    says(R"({"kind": "weight", "points_mm": []})", "weight");
    says(R"({"kind": "distance", "points_mm": [[0, 0, 0]]})", "1 points_mm in place of 2");
    says(R"({"kind": "angle", "points_mm": [[0, 0, 0], [1, 0, 0]]})", "in place of 3");
    says(R"({"kind": "distance", "points_mm": [[0, 0, 0], [1e9, 0, 0]]})", "1000000000.0");
    says(R"({"kind": "distance", "points_mm": [[0, 0, 0], [1, 0]]})", "is damaged");
    says(R"({"kind": "diameter", "points_mm": [[0, 0, 0], [1, 0, 0]], "stenosis": 1.5})", "1.5");
    says(R"({"points_mm": [[0, 0, 0], [1, 0, 0]]})", "kind");
    for (const char* wrong :
         {"text", "[]", R"({"format": "x", "version": 1, "measurements": []})",
          R"({"format": "hepatica-measurements", "version": 2, "measurements": []})",
          R"({"format": "hepatica-measurements", "version": 1})"})
        EXPECT_THROW(measurements_from_json(wrong, "a file"), InputError) << wrong;
}

class MeasuredCase : public ::testing::Test {
  protected:
    MeasuredCase()
        : folder_(fs::temp_directory_path() / ("measured_case_" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~MeasuredCase() override { fs::remove_all(folder_); }
    fs::path folder_;
};

TEST_F(MeasuredCase, KeepsWhatWasMeasuredInAFileThatMayBeRemoved) {
    PatientCase patient = test::some_patient();
    patient.measured = measured;
    for (const char* name : {"p.hep", "p.hepz"}) {
        write_case(folder_ / name, patient);
        EXPECT_EQ(read_case(folder_ / name).measured, measured) << name;
    }
    const fs::path file = folder_ / "p.hep" / case_file::measurements;
    std::ofstream(file) << R"({"format": 7})";
    try {
        read_case_without_voxels(folder_ / "p.hep");
        ADD_FAILURE() << "it is damaged";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file.string());
        EXPECT_NE(error.problem().find('7'), std::string::npos) << error.problem();
    }
    fs::remove(file);
    EXPECT_TRUE(read_case(folder_ / "p.hep").measured.empty());
    // Saved without any, the older ones do not stay.
    write_case(folder_ / "p.hep", patient);
    write_case(folder_ / "p.hep", test::some_patient());
    EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace hepatica
