// SPDX-License-Identifier: GPL-3.0-or-later
// A case in one file. The other zip program is Python's zipfile.
#include "core/patient/case_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "tests/patient/some_patient.h"
#include "tests/support/shell.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

class CaseArchive : public testing::Test {
  protected:
    // Runs Python in the folder, with zipfile at hand.
    void python(const std::string& program) const {
        const test::ShellAnswer answer =
            test::shell("cd '" + folder_.path().string() +
                        "' && python3 -W ignore -c 'import zipfile, os\n" + program + "'");
        ASSERT_EQ(answer.exit_code, 0) << answer.output;
    }
    fs::path in(const std::string& name) const { return folder_.path() / name; }

    // Why unpacking it is refused; empty where it is not. Nothing appears outside of its folder.
    std::string refusal(const fs::path& archive) const {
        const TemporaryFolder outer;
        fs::create_directories(outer.path() / "a/b");
        std::string why;
        try {
            unpack_case(archive, outer.path() / "a/b");
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), archive.string());
            why = error.problem();
        }
        EXPECT_EQ(std::distance(fs::directory_iterator(outer.path()), {}), 1);
        EXPECT_EQ(std::distance(fs::directory_iterator(outer.path() / "a"), {}), 1);
        return why;
    }
    std::string refusal_of_names(const std::string& names) const {
        python("with zipfile.ZipFile(\"x.hepz\", \"w\") as z:\n  for n in [" + names +
               "]: z.writestr(n, \"x\")");
        return refusal(in("x.hepz"));
    }

    const TemporaryFolder folder_;
};

TEST_F(CaseArchive, HoldsTheSameCaseAsAFolder) {
    const PatientCase patient = test::some_patient();
    write_case(in("p.hep"), patient);
    write_case(in("p.hepz"), patient);
    ASSERT_TRUE(is_case(in("p.hepz")));
    const PatientCase back = read_case(in("p.hepz"));
    EXPECT_EQ(hash_of(back), hash_of(patient));
    EXPECT_EQ(back.mask.voxels, patient.mask.voxels);
    EXPECT_EQ(back.organs.voxels, patient.organs.voxels);
    EXPECT_EQ(back.source.name, patient.source.name);
    PatientCase lean = read_case_without_voxels(in("p.hepz"));
    EXPECT_TRUE(lean.mask.voxels.empty());
    add_voxels(in("p.hepz"), lean);
    EXPECT_EQ(lean.mask.voxels, patient.mask.voxels);
    python(
        "z = zipfile.ZipFile(\"p.hepz\")\nassert z.testzip() is None\n"
        "assert sorted(z.namelist()) == sorted(os.listdir(\"p.hep\"))\n"
        "for i in z.infolist():\n  assert z.read(i) == open(\"p.hep/\" + i.filename, "
        "\"rb\").read()\n"
        "  assert i.date_time == (1980, 1, 1, 0, 0, 0)");
}

TEST_F(CaseArchive, OfAnotherProgramIsRead) {
    const PatientCase patient = test::some_patient();
    write_case(in("p.hep"), patient);
    for (const char* method : {"STORED", "DEFLATED"}) {
        python("with zipfile.ZipFile(\"q.HEPZ\", \"w\", zipfile.ZIP_" + std::string(method) +
               ") as z:\n  for n in os.listdir(\"p.hep\"): z.write(\"p.hep/\" + n, n)");
        EXPECT_EQ(hash_of(read_case(in("q.HEPZ"))), hash_of(patient));
    }
}

TEST_F(CaseArchive, OfTheSameCaseHasTheSameBytes) {
    write_case(in("a.hepz"), test::some_patient());
    write_case(in("b.hepz"), test::some_patient());
    EXPECT_EQ(bytes_of(in("a.hepz")), bytes_of(in("b.hepz")));
}

TEST_F(CaseArchive, KeepsTheDialThatIsLeftInIt) {
    const PatientCase patient = test::some_patient();
    write_case(in("p.hepz"), patient);
    write_dial(in("p.hepz"), R"({"front": 1})");
    const PatientCase back = read_case(in("p.hepz"));
    EXPECT_EQ(back.dial_json, R"({"front": 1})");
    EXPECT_EQ(back.mask.voxels, patient.mask.voxels);
}

TEST_F(CaseArchive, ReplacesAnOlderCaseAndNothingElse) {
    write_case(in("p.hepz"), test::some_patient());
    write_case(in("p.hepz"), test::some_patient());
    write_bytes(in("notes.hepz"), "my notes");
    EXPECT_THROW(write_case(in("notes.hepz"), test::some_patient()), InputError);
    EXPECT_EQ(bytes_of(in("notes.hepz")), "my notes");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 2) << "something is left";
}

TEST_F(CaseArchive, IsNotWrittenInThePlaceOfAFolder) {
    fs::create_directory(in("folder.hepz"));
    try {
        require_place_of_case(in("folder.hepz"));
        ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
        EXPECT_THAT(error.problem(), HasSubstr("is a folder"));
        EXPECT_EQ(error.place(), in("folder.hepz").string());
        EXPECT_NE(error.remedy(), "");
    }
    EXPECT_THROW(write_case(in("folder.hepz"), test::some_patient()), InputError);
    EXPECT_TRUE(fs::is_empty(in("folder.hepz")));
    write_case(in("p.hepz"), test::some_patient());
    EXPECT_NO_THROW(require_place_of_case(in("p.hepz")));
    EXPECT_NO_THROW(require_place_of_case(in("new.hepz")));
}

// Such as the lessons for the patient; another patient's are none for this one.
TEST_F(CaseArchive, KeepsWhatLiesBesideTheSameCase) {
    PatientCase patient = test::some_patient();
    const TemporaryFolder unpacked;
    write_case(in("p.hepz"), patient);
    unpack_case(in("p.hepz"), unpacked.path());
    write_bytes(unpacked.path() / "lesson-1.json", "a lesson");
    pack_case(unpacked.path(), in("p.hepz"));
    patient.source.name = "Corrected";
    write_case(in("p.hepz"), patient);
    EXPECT_EQ(read_case(in("p.hepz")).source.name, "Corrected");
    const TemporaryFolder again;
    unpack_case(in("p.hepz"), again.path());
    EXPECT_EQ(bytes_of(again.path() / "lesson-1.json"), "a lesson");
    patient.source.image_sha256 = std::string(64, 'b');
    write_case(in("p.hepz"), patient);
    EXPECT_FALSE(archive_holds(in("p.hepz"), "lesson-1.json"));
}

// Otherwise the work that is to be saved would be lost.
TEST_F(CaseArchive, ThatIsDamagedIsReplaced) {
    write_case(in("p.hepz"), test::some_patient());
    std::string bytes = bytes_of(in("p.hepz"));
    const TemporaryFolder unpacked;
    for (std::size_t at = bytes.size() / 2; at < bytes.size() / 2 + 64; ++at) bytes[at] ^= '\x55';
    write_bytes(in("p.hepz"), bytes);
    ASSERT_THROW(unpack_case(in("p.hepz"), unpacked.path()), InputError);
    ASSERT_TRUE(is_replaceable_case(in("p.hepz")));
    write_case(in("p.hepz"), test::some_patient());
    EXPECT_EQ(read_case(in("p.hepz")).source.name, test::some_patient().source.name);
}

// As those that come from a tree, not from a CT.
TEST_F(CaseArchive, KeepsNothingOfAnotherPatientWithoutACt) {
    PatientCase patient = test::some_patient();
    patient.source.image_sha256.clear();
    patient.corrections = {};
    const TemporaryFolder unpacked;
    write_case(in("p.hepz"), patient);
    unpack_case(in("p.hepz"), unpacked.path());
    write_bytes(unpacked.path() / "lesson-1.json", "a lesson");
    pack_case(unpacked.path(), in("p.hepz"));
    write_case(in("p.hepz"), patient);
    EXPECT_TRUE(archive_holds(in("p.hepz"), "lesson-1.json"));
    patient.tree.segments.front().radii_mm.front() += 0.5;
    write_case(in("p.hepz"), patient);
    EXPECT_FALSE(archive_holds(in("p.hepz"), "lesson-1.json"));
}

TEST_F(CaseArchive, WithNamesThatClimbOutIsRefused) {
    const std::vector<std::string> names{
        "../evil", "../../evil", in("evil").string(), "a/b", "a/", "..", ".", ".hidden", "a\\\\b",
        "c:evil",  "a b",        "\\u00e4",           "\\n"};
    std::string list;
    for (const std::string& name : names) list += "\"" + name + "\", ";
    python("for i, n in enumerate([" + list +
           "]):\n  with zipfile.ZipFile(str(i) + \".hepz\", \"w\") as z:\n"
           "    z.writestr(\"case.json\", \"x\")\n    z.writestr(n, \"x\")");
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_THAT(refusal(in(std::to_string(i) + ".hepz")),
                    HasSubstr("whose name no file of a case has"))
            << names[i];
    EXPECT_FALSE(fs::exists(in("evil")));
    EXPECT_THAT(refusal_of_names("\"a\", \"b\", \"a\""), HasSubstr("twice"));
    EXPECT_THAT(refusal_of_names("\"x\" * 3000"), HasSubstr("whose name"));
    EXPECT_EQ(refusal_of_names("\"case.json\", \"mask.nii.gz\""), "");
}

TEST_F(CaseArchive, ThatIsABombIsRefused) {
    python(
        "with zipfile.ZipFile(\"x.hepz\", \"w\", zipfile.ZIP_DEFLATED) as z:\n"
        "  z.writestr(\"mesh.vtu\", bytes(17 << 20))");
    EXPECT_THAT(refusal(in("x.hepz")), HasSubstr("more than a case can"));
    EXPECT_THAT(refusal_of_names("str(i) for i in range(65)"), HasSubstr("more files"));
    EXPECT_EQ(refusal_of_names("str(i) for i in range(64)"), "");
}

// Twenty bytes that say they are ten: both headers lie alike.
TEST_F(CaseArchive, ThatLiesAboutSizesIsRefused) {
    python(
        "with zipfile.ZipFile(\"x.hepz\", \"w\") as z: z.writestr(\"a\", \"0123456789\" * 2)\n"
        "d = open(\"x.hepz\", \"rb\").read()\n"
        "open(\"x.hepz\", \"wb\").write(d.replace(b\"\\x14\\0\\0\\0\\x14\\0\\0\\0\", "
        "b\"\\x0a\\0\\0\\0\\x0a\\0\\0\\0\"))");
    EXPECT_THAT(refusal(in("x.hepz")), HasSubstr("is damaged"));
}

TEST_F(CaseArchive, CutAnywhereIsRefused) {
    write_case(in("p.hepz"), test::some_patient());
    const std::string whole = bytes_of(in("p.hepz"));
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
        write_bytes(in("cut.hepz"), whole.substr(0, size));
        EXPECT_NE(refusal(in("cut.hepz")), "") << size << " of " << whole.size() << " bytes";
    }
}

// A byte that is another: either the archive is refused or the case is the same.
TEST_F(CaseArchive, DamagedAnywhereIsRefusedOrTheSame) {
    const PatientCase patient = test::some_patient();
    write_case(in("p.hepz"), patient);
    const std::string whole = bytes_of(in("p.hepz"));
    std::mt19937 random(5);
    int refused = 0;
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
        std::string bytes = whole;
        // Half of them at the end, where the list of files is.
        const std::size_t from = i % 2 == 0 ? 0 : whole.size() - 900;
        bytes[from + random() % (whole.size() - from)] ^= static_cast<char>(1 + random() % 255);
        write_bytes(in("bad.hepz"), bytes);
        try {
            EXPECT_EQ(hash_of(read_case_without_voxels(in("bad.hepz"))), hash_of(patient));
        } catch (const InputError& error) {
            ++refused;
            EXPECT_THAT(error.place(), testing::StartsWith(in("bad.hepz").string()));
        }
    }
    EXPECT_GT(refused, tries / 2);
}

TEST_F(CaseArchive, ErrorsNameTheFileInTheArchive) {
    write_case(in("p.hep"), test::some_patient());
    write_bytes(in("p.hep/tree.vtp"), "another");
    pack_case(in("p.hep"), in("p.hepz"));
    try {
        read_case(in("p.hepz"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), in("p.hepz/tree.vtp").string());
    }
}

}  // namespace
}  // namespace hepatica
