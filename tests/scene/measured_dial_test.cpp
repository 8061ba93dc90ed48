// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/measured_dial.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/deform_part.h"
#include "core/scene/setting_json.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::small_patient;

StepperOptions substeps(int count) {
    StepperOptions options;
    options.substeps = count;
    return options;
}

TEST(MeasuredDial, CostsMoreAndMissesLessAsItTurns) {
    const QualityDial dial = built_in_dial(20000);
    const QualityPoint* last = &dial.at(0.0);
    int changes = 0;
    for (int i = 1; i <= 100; ++i) {
        const QualityPoint& now = dial.at(0.01 * i);
        if (&now == last) continue;
        ++changes;
        EXPECT_GT(now.frame_ms, last->frame_ms);
        EXPECT_LT(now.error_relative, last->error_relative);
        last = &now;
    }
    EXPECT_GE(changes, 3);
    EXPECT_LT(dial.at(1.0).error_relative, 0.75 * dial.at(0.0).error_relative);
}

TEST(MeasuredDial, SaysWhatTheErrorWasMeasuredAgainst) {
    const QualityDial dial = dial_of(*small_patient());
    for (const QualityPoint& point : dial.front()) {
        EXPECT_GT(point.error_relative, 0.0);
        EXPECT_NE(point.reference.find("synthetic patient"), std::string::npos);
    }
}

TEST(MeasuredDial, IsThePatientsOwnWhereTheCaseHoldsOne) {
    PatientCase patient = *small_patient();
    const std::vector<QualityPoint> measured{{substeps(1), 3.0, 0.4, "this body"},
                                             {substeps(3), 9.0, 0.1, "this body"}};
    patient.dial_json = dial_json(measured, patient);
    const QualityDial dial = dial_of(patient);
    ASSERT_EQ(dial.front().size(), 2u);
    EXPECT_EQ(dial.front()[1].reference, "this body");
    EXPECT_EQ(dial.front()[1].options.substeps, 3);
    EXPECT_EQ(dial.front()[1].error_relative, 0.1);
    EXPECT_EQ(dial.front()[0].frame_ms, 3.0);
    const DeformPart part(patient, DeformSpec{.quality = 1.0});
    EXPECT_EQ(part.setting().substeps, 3);

    patient.mesh.vertices_mm[0].x() += 0.01;  // another mesh than the one measured
    EXPECT_NE(dial_of(patient).front()[0].reference, "this body");
}

TEST(MeasuredDial, LeavesOneAsideThatWasMeasuredInAnotherWay) {
    PatientCase patient = *small_patient();
    patient.dial_json = R"({"format": "hepatica-dial", "version": 1})";
    EXPECT_TRUE(measured_points(patient).empty());
    EXPECT_NE(dial_of(patient).front()[0].reference.find("synthetic patient"), std::string::npos);
}

TEST(MeasuredDial, OffersNothingThatMissesMoreThanHalfTheMotion) {
    PatientCase patient = *small_patient();
    patient.dial_json = dial_json(
        {{substeps(1), 3.0, 0.6, "this body"}, {substeps(2), 6.0, 0.4, "this body"}}, patient);
    EXPECT_EQ(measured_points(patient).size(), 2u);
    ASSERT_EQ(dial_of(patient).front().size(), 1u);
    EXPECT_EQ(dial_of(patient).front()[0].options.substeps, 2);
    // Where nothing is better, it is what there is.
    patient.dial_json = dial_json({{substeps(1), 3.0, 0.6, "this body"}}, patient);
    EXPECT_EQ(dial_of(patient).front().size(), 1u);
}

// A device that this program knows by name alone.
DeformBackEnd device(const std::string& name, bool beside_processor = false) {
    DeformBackEnd back_end = cpu_back_end();
    back_end.name = "cuda";
    back_end.device = name;
    back_end.beside_processor = beside_processor;
    return back_end;
}

// Two settings of the processor and two of a device between them.
PatientCase patient_with_both() {
    PatientCase patient = *small_patient();
    patient.dial_json = dial_json({{substeps(1), 3.0, 0.4, "this body"},
                                   {substeps(4), 12.0, 0.2, "this body"},
                                   {substeps(2), 4.0, 0.3, "this body", "cuda", "H200"},
                                   {substeps(8), 9.0, 0.1, "this body", "cuda", "H200"}},
                                  patient);
    return patient;
}

TEST(MeasuredDial, NamesTheBackEndOfEachSettingAndKeepsIt) {
    const PatientCase patient = patient_with_both();
    const auto json = nlohmann::json::parse(patient.dial_json);
    EXPECT_EQ(json["version"], 4) << "a program that knows 3 takes all for the processor's";
    EXPECT_EQ(json["points"][0]["back_end"], "cpu");
    EXPECT_FALSE(json["points"][0].contains("device"));
    EXPECT_EQ(json["points"][3]["back_end"], "cuda");
    EXPECT_EQ(json["points"][3]["device"], "H200");
    const std::vector<QualityPoint> read = measured_points(patient);
    ASSERT_EQ(read.size(), 4u);
    EXPECT_EQ(read[1].back_end, "cpu");
    EXPECT_EQ(read[1].device, "");
    EXPECT_EQ(read[2].back_end, "cuda");
    EXPECT_EQ(read[2].device, "H200");
}

TEST(MeasuredDial, OffersOnADeviceWhatWasMeasuredThereAndBesideItTheProcessors) {
    const PatientCase patient = patient_with_both();
    const auto substeps_on = [&](const DeformBackEnd& back_end) {
        std::vector<int> counts;  // below zero: on the processor of a play on a device
        const QualityDial dial = dial_of(patient, back_end);
        for (const QualityPoint& point : dial.front())
            counts.push_back(point.options.on_processor ? -point.options.substeps
                                                        : point.options.substeps);
        return counts;
    };
    EXPECT_EQ(substeps_on(cpu_back_end()), (std::vector{1, 4}));
    EXPECT_EQ(substeps_on(device("H200")), (std::vector{2, 8}));
    // The processor's four substeps cost more than the device's eight, and miss more.
    EXPECT_EQ(substeps_on(device("H200", true)), (std::vector{-1, 2, 8}));
}

TEST(MeasuredDial, LeavesOutADeviceThatIsNotThereAndSaysSo) {
    const PatientCase patient = patient_with_both();
    const std::vector<QualityPoint> points = measured_points(patient);
    EXPECT_EQ(words_on_left_out(device("H200"), points), "");
    for (const DeformBackEnd& other : {cpu_back_end(), device("H100"), device("H100", true)})
        EXPECT_NE(words_on_left_out(other, points).find("measured on H200 (cuda) are left out"),
                  std::string::npos);
    EXPECT_TRUE(points_for(device("H100", true), points).empty());
    EXPECT_FALSE(is_of_own_body(dial_of(patient, device("H100", true)).front()[0].reference));
}

TEST(MeasuredDial, OfOlderProgramsIsTheProcessors) {
    PatientCase patient = *small_patient();
    patient.dial_json = dial_json({{substeps(3), 3.0, 0.4, "this body"}}, patient);
    auto json = nlohmann::json::parse(patient.dial_json);
    EXPECT_EQ(json["version"], 3) << "without a device older programs read it";
    json["points"][0].erase("back_end");
    patient.dial_json = json.dump();
    ASSERT_EQ(dial_of(patient).front().size(), 1u);
    EXPECT_EQ(dial_of(patient).front()[0].options.substeps, 3);
    EXPECT_EQ(measured_points(patient)[0].back_end, "cpu");
    EXPECT_EQ(words_on_left_out(cpu_back_end(), measured_points(patient)), "");
    EXPECT_FALSE(is_of_own_body(dial_of(patient, device("H200")).front()[0].reference));
}

TEST(MeasuredDial, RefusesADamagedOneByName) {
    PatientCase patient = *small_patient();
    for (const char* damaged : {"[]", "{", "{\"format\": \"hepatica-dial\", \"version\": 3}",
                                "{\"format\": \"hepatica-dial\", \"version\": 5}",
                                "{\"format\": \"hepatica-dial\", \"version\": \"two\"}",
                                "{\"format\": \"other\", \"version\": 3}"}) {
        patient.dial_json = damaged;
        EXPECT_THROW(static_cast<void>(dial_of(patient)), InputError) << damaged;
    }
    for (const char* no_object : {"[]", "{", "3"}) {
        patient.dial_json = no_object;
        try {
            static_cast<void>(dial_of(patient));
            ADD_FAILURE() << no_object;
        } catch (const InputError& error) {
            EXPECT_EQ(error.problem(), "is damaged") << no_object;
        }
    }
}

TEST(SettingJson, ComesBackAsItWasAndRefusesTheRest) {
    StepperOptions options;
    options.model = ElementModel::neohookean;
    options.order = ElementOrder::quadratic;
    options.solver = LinearSolverKind::block_jacobi;
    options.linear = {.energy_tolerance = 0.1 + 0.2, .max_iterations = 7};
    options.newton_iterations = 3;
    options.substeps = 5;
    EXPECT_TRUE(same_setting(setting_from_json(to_json(options)), options));
    EXPECT_FALSE(same_setting(options, StepperOptions{}));
    options.on_processor = true;
    EXPECT_TRUE(same_setting(setting_from_json(to_json(options)), options));
    EXPECT_FALSE(setting_from_json(to_json(StepperOptions{})).on_processor);
    EXPECT_NE(words_of(options).find("on the processor"), std::string::npos);
    options.swing_substeps = 1;
    EXPECT_EQ(setting_from_json(to_json(options)).swing_substeps, 1);
    options.published = true;
    EXPECT_TRUE(setting_from_json(to_json(options)).published);
    EXPECT_FALSE(setting_from_json(to_json(StepperOptions{})).published);
    using Json = nlohmann::ordered_json;
    for (const Json& wrong :
         {Json({{"element", "spring-10"}}), Json({{"solver", "magic"}}), Json({{"substeps", 0}}),
          Json({{"swing_substeps", 0}}), Json({{"swing_substeps", 65}}),
          Json({{"substeps", 1000000000}}), Json({{"newton_iterations", 2000000000}}),
          Json({{"max_iterations", 2000000000}}), Json({{"substeps", "two"}}),
          Json({{"nonsense", 1}}), Json::array()})
        EXPECT_THROW(static_cast<void>(setting_from_json(wrong)), InputError) << wrong.dump();
}

}  // namespace
}  // namespace hepatica
