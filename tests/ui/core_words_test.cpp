// SPDX-License-Identifier: GPL-3.0-or-later
// What core says is said in German, too: every sentence of core's sources has a translation, and a
// sentence finds its own whatever was put into it.
#include "ui/core_words.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "ui/core_sentences.h"
#include "ui/date_words.h"
#include "ui/language.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica::testing {
namespace {

namespace fs = std::filesystem;

class Speaks {
  public:
    explicit Speaks(const QString& language) { use_language(language); }
    ~Speaks() { use_language("en"); }
    Speaks(const Speaks&) = delete;
    Speaks& operator=(const Speaks&) = delete;
};

// What never reaches the window, as part of a path.
constexpr std::array elsewhere{
    "core/accuracy/",                   // verbs of the command line
    "core/links/",                      // models: options of the command line
    "core/training/",                   // a verb of the command line
    "core/phantom/disturbances",        // what training draws
    "core/phantom/phantom_range",       // options of phantoms
    "core/phantom/phantom.cpp",         // its options
    "core/phantom/phantom_growth.cpp",  // likewise
    "core/study/extreme",               // the study of extremes
    "core/study/",                      // benchmarks; the stages of the dial are asked for below
    "core/contact/",                    // what programmers do wrong
    "core/deform/",                     // likewise; what frames say is asked for below
    "core/tear/",                       // likewise
    "core/haptics/",                    // drivers of devices: no window offers one yet
    "core/flow/embolization",           // verbs of the command line
    "core/flow/flow_export",            // likewise
    "core/flow/fluid.cpp",              // sources of numbers, which JSON states
    "core/mesh/brick_mesh",             // bodies of tests and studies
    "core/opening/case_segmentation",   // names that DICOM gives
    "core/scene/scene_spec",            // scenes in files: the command line
    "core/scene/setting_json",          // likewise
    "core/session/script",              // scripts: the command line
    "core/session/command.cpp",         // likewise
};

// Words that are no sentences: of files, formats and programmers.
const std::array no_sentences{
    std::regex("^(unsigned|signed|short|long) "),
    std::regex("NRRD0004|Segmentation_|Synthetic"),
    std::regex("^(space|byte|line|data) (origin|directions|skip|file)$"),
    std::regex("^--seed-mm X,Y,Z,(portal|hepatic|artery)$"),  // window_words.cpp names its field
    std::regex("^parse error at line $"),                     // window_words.cpp says where instead
    std::regex("^\\\\nspace|^\\\\nkinds"),
    std::regex("^# |^\\\\n#"),
    std::regex("^%|as they lie$"),
    std::regex("^no UID$"),
    std::regex("^(mpr thick|pv phase|sans inj|non contrast|no contrast|screen save)$"),
    std::regex("^dose (report|info|record|summary)$"),
};

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

// The literals of a source, those that stand beside each other as one. Comments are left out.
std::vector<std::string> literals_in(const std::string& source) {
    const std::string code = std::regex_replace(
        std::regex_replace(source, std::regex("(^|\n)\\s*(//|#include)[^\n]*"), "\n"),
        std::regex("//[^\"\n]*(?=\n)"), "");
    static const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re");
    static const std::regex literals(R"re("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)re");
    std::vector<std::string> found;
    for (std::sregex_iterator match(code.begin(), code.end(), literals), end; match != end;
         ++match) {
        const std::string beside = match->str();
        std::string whole;
        for (std::sregex_iterator piece(beside.begin(), beside.end(), literal); piece != end;
             ++piece)
            whole += (*piece)[1];
        found.push_back(whole);
    }
    return found;
}

bool is_prose(const std::string& literal) {
    static const std::regex words("\\S\\s+\\S"), letters("[a-z]{2}");
    return std::regex_search(literal, words) && std::regex_search(literal, letters) &&
           std::ranges::none_of(no_sentences, [&](const std::regex& other) {
               return std::regex_search(literal, other);
           });
}

std::string unescaped(std::string literal) {
    for (const char* sign : {"\\\"", "\\n"})
        for (std::size_t at; (at = literal.find(sign)) != std::string::npos;)
            literal.replace(at, 2, sign[1] == 'n' ? "\n" : "\"");
    return literal;
}

bool is_said(const std::string& fragment) {
    return std::ranges::any_of(core_sentences(), [&](const char* sentence) {
        return std::string_view(sentence).find(fragment) != std::string_view::npos;
    });
}

TEST(CoreWords, KnowEverySentenceOfCore) {
    for (const auto& entry : fs::recursive_directory_iterator(HEPATICA_SOURCE_DIR "/core")) {
        const fs::path& file = entry.path();
        const bool is_source = file.extension() == ".cpp" || file.extension() == ".h";
        if (!is_source || std::ranges::any_of(elsewhere, [&](const char* part) {
                return file.string().find(part) != std::string::npos;
            }))
            continue;
        for (const std::string& literal : literals_in(text_of(file)))
            if (is_prose(literal)) {
                EXPECT_TRUE(is_said(unescaped(literal)))
                    << file.string() << " says \"" << literal
                    << "\", which has no place in ui/sentences_of_*.cpp";
            }
    }
}

// Stages of the verbs that the command line alone has.
bool is_of_the_window(const fs::path& file) {
    const bool is_study = file.string().find("/core/study/") != std::string::npos;
    return file.filename() != "embolization.cpp" && file.filename() != "link_training.cpp" &&
           (!is_study || file.filename() == "dial_study.cpp" ||
            file.filename() == "hand_trial.cpp");
}

TEST(CoreWords, KnowEveryStageAndEveryMessageOfAStep) {
    static const std::regex said("(begin_stage\\(|message \\+?= )\"([^\"]*)\"");
    int found = 0;
    for (const auto& entry : fs::recursive_directory_iterator(HEPATICA_SOURCE_DIR "/core")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string source = text_of(entry.path());
        for (std::sregex_iterator match(source.begin(), source.end(), said), end; match != end;
             ++match, ++found)
            if (is_of_the_window(entry.path())) {
                EXPECT_TRUE(is_said((*match)[2])) << entry.path() << " says " << (*match)[2];
            }
    }
    EXPECT_GT(found, 30);
}

TEST(CoreWords, KnowEveryTextOfTheLessonsBuiltIn) {
    const std::function<void(const nlohmann::json&)> look = [&](const nlohmann::json& node) {
        if (!node.is_structured()) return;
        for (const auto& [key, value] : node.items()) {
            const bool is_text = key == "name" || key == "about" || key == "text" || key == "hint";
            if (is_text && value.is_string()) {
                EXPECT_TRUE(is_said(value.get<std::string>())) << value;
            }
            if (key == "marks" && value.is_object()) {
                for (const auto& [mark, place] : value.items()) EXPECT_TRUE(is_said(mark)) << mark;
            }
            if (key != "scene") look(value);  // its name is no text
        }
    };
    for (const auto& entry : fs::directory_iterator(HEPATICA_SOURCE_DIR "/assets/lessons"))
        look(nlohmann::json::parse(text_of(entry.path())));
}

TEST(CoreWords, AreSaidInGermanWithWhatIsPutIn) {
    const Speaks german("de");
    const std::pair<const char*, const char*> expected[]{
        {"portal vein", "Pfortader"},
        {"Finding the liver", "Die Leber wird gesucht"},
        {"12.5 mN", "12,5 mN"},
        {"the window runs from 120.5 to 80 HU", "Das Fenster reicht von 120,5 bis 80 HU"},
        {"is flat or inverted (volume -1.66667e-19 mm3)",
         "ist flach oder umgestülpt (Volumen -1,66667e-19 mm3)"},
        {"its parameter mesh.cell_size_in_radii is [], not a number",
         "sein Parameter mesh.cell_size_in_radii ist [], keine Zahl"},
        {"distance of the tip to the first mark at most 12 mm",
         "Abstand der Spitze zu „erste Marke“ höchstens 12 mm"},
        {"limit broken: force at most 200 mN, but it was 200.5 mN",
         "Grenze verletzt: Kraft höchstens 200 mN, es war aber 200,5 mN"},
        {"the vessel would join two systems: portal vein and hepatic veins",
         "das Gefäß würde zwei Systeme verbinden: Pfortader und Lebervenen"},
        {"1.5, -2.0, 30.0 mm", "1,5; -2,0; 30,0 mm"},
        {"The processor makes the steps: the device failed (no memory on the device: out of "
         "memory)",
         "Der Prozessor macht die Schritte: das Gerät ist ausgefallen (kein Speicher auf dem "
         "Gerät: out of memory)"},
        {"Settings of the dial that were measured on NVIDIA X (cuda) are left out: it does not "
         "make the steps here",
         "Einstellungen des Schiebers, die auf NVIDIA X (cuda) gemessen wurden, fehlen: Es macht "
         "die Schritte hier nicht"},
        {"corotated, 2 substeps, on the processor", "korotiert, 2 Teilschritte, auf dem Prozessor"},
        {"Read series 5 “CT Body 3.0” (CT, 60 images, 1.5 mm apart, kernel “Br38f/3”) and left out "
         "a series “lung” (CT, 8 images) as asked for. On the command line --series 1 reads the "
         "one that was left out.",
         "Gelesen wurde wie verlangt Serie 5 “CT Body 3.0” (CT, 60 Bilder, Abstand 1,5 mm, Kern "
         "“Br38f/3”), ausgelassen eine Serie “lung” (CT, 8 Bilder). Die ausgelassene liest Datei > "
         "Mit Optionen rekonstruieren, Serie 1."},
        {"Read a series “lung” (CT, 8 images) and left out 2 others as asked for, the best of them "
         "series 5 “CT Body 3.0” (CT, 60 images). On the command line --series 1 reads that one, "
         "and other numbers read the others.",
         "Gelesen wurde wie verlangt eine Serie “lung” (CT, 8 Bilder), ausgelassen wurden 2 "
         "andere. Die beste davon, Serie 5 “CT Body 3.0” (CT, 60 Bilder), liest Datei > Mit "
         "Optionen "
         "rekonstruieren, Serie 1; andere Nummern lesen die anderen."},
        // As the window says it in English.
        {"On the command line --series", "On the command line --series"},
        {"Leave the series out, or give a DICOM folder",
         "Lassen Sie die Serie weg, oder geben Sie einen DICOM-Ordner an"},
    };
    for (const auto& [english, words] : expected)
        EXPECT_EQ(translated(english).toStdString(), words);
}

TEST(CoreWords, LeaveNamesAlone) {
    const Speaks german("de");
    for (const char* name : {"ct.nii.gz", "/data/p1.5/ct", "Müller 1.2.840.113619", "100 %1", ""})
        EXPECT_EQ(translated(name).toStdString(), name);
    EXPECT_EQ(translated("is \"50 %2 %1\", which is no tool").toStdString(),
              "ist „50 %2 %1“, kein Werkzeug");
    EXPECT_EQ(translated("series 5 “liver and spleen”").toStdString(),
              "Serie 5 “liver and spleen”");
}

TEST(CoreWords, StayAsTheyAreInEnglish) {
    for (const char* text : {"the window runs from 1.5 to 2.5 HU", "12.5 mN", "portal vein"})
        EXPECT_EQ(translated(text).toStdString(), text);
}

// A person at the window has no key and no documents of the sources.
TEST(WindowWords, SayWhatIsWrongWithAFileAndWhatHelps) {
    EXPECT_EQ(in_window_words("has no \"steps\""), "lacks its steps (\"steps\")");
    EXPECT_EQ(in_window_words("is damaged (parse error at line 3, column 5: syntax error while "
                              "parsing value - invalid literal; last read: 'x')"),
              "is damaged: it cannot be read from line 3, column 5 on");
    for (const char* remedy :
         {"See docs/lessons.md, and assets/lessons for lessons that work",
          "Add it: see docs/lessons.md", "docs/scenes.md lists the keys of a scene"})
        EXPECT_EQ(in_window_words(remedy).find("docs/"), std::string::npos) << remedy;
    const Speaks german("de");
    EXPECT_EQ(translated(in_window_words("is damaged (parse error at line 3, column 5: syntax)")),
              QString("ist beschädigt: Ab Zeile 3, Spalte 5 ist sie nicht lesbar"));
    EXPECT_FALSE(translated(in_window_words("Add it: see docs/lessons.md")).contains("docs/"));
    EXPECT_EQ(translated("cannot be written (No such file or directory)"),
              QString("lässt sich nicht schreiben (Datei oder Ordner fehlt)"));
    EXPECT_EQ(translated("corotated, 4 substeps"), QString("korotiert, 4 Teilschritte"));
}

TEST(DateWords, HaveAPointBehindAGermanDay) {
    const QDateTime when(QDate(2026, 11, 6), QTime(9, 5));
    EXPECT_EQ(date_words(when), "6 Nov 2026, 09:05");
    const Speaks german("de");
    EXPECT_EQ(date_words(when), "6. Nov. 2026, 09:05");
}

}  // namespace
}  // namespace hepatica::testing
