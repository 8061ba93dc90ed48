// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels given to a system through the real program: what changes nothing is said, and what is
// missing where it cannot be done.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "tests/app/tour.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

TEST(EditSystems, SaysThatAVesselHadTheSystemThatItIsGivenTo) {
    const fs::path folder = fs::path(testing::TempDir()) / "edit systems";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path patient = folder / "p.hep", edits = folder / "edits.json";
    write_case(patient, test::patient_with_bridges());
    const auto said_of = [&](const std::string& list) {
        std::ofstream(edits) << list;
        const test::Json said = test::answer({"edit", patient.string(), "--edits", edits.string()});
        return said.at("warnings").dump();
    };
    const std::string give = R"({"edit": "reassign_system", "at_mm": [37, 54.5, 4], "system": ")";
    EXPECT_EQ(said_of("[" + give + "hepatic\"}]").find("given to already"), std::string::npos);
    EXPECT_NE(said_of("[" + give + "hepatic\"}]").find("given to already: hepatic veins"),
              std::string::npos);
    EXPECT_EQ(said_of("[" + give + "portal\"}, " + give + "hepatic\"}]").find("given to already"),
              std::string::npos)
        << "each is judged by the edits before it";
    fs::remove_all(folder);
}

// The place was written as it should be; what is missing is the system.
TEST(EditSystems, SaysWhatIsMissingOfASeed) {
    const fs::path folder = fs::path(testing::TempDir()) / "edit seeds";
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_case(folder / "p.hep", test::patient_with_bridges());
    for (const auto& [seed, said] :
         {std::pair<std::string, std::string>{"1,2,3", "names no system"},
          {",portal", "is no seed"},
          {"1,2,portal", "is no seed"},
          {"1,2,x,portal", "is not three numbers"},
          {"1,2,3,nowhere", "there is no vascular system nowhere"}}) {
        const test::Outcome run =
            test::run_cli({"edit", (folder / "p.hep").string(), "--seed", seed});
        EXPECT_EQ(run.exit_code, 2) << seed << run.errors;
        EXPECT_NE(run.errors.find(said), std::string::npos) << run.errors;
    }
    fs::remove_all(folder);
}

}  // namespace
}  // namespace hepatica
