#include "support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using dioptre::test::Outcome;
using dioptre::test::run;

namespace
{

nlohmann::json findings(const std::string& command)
{
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.out);
}

// With a copy of glsl/ in which one file is edited by sed.
Outcome withEdited(const std::string& file, const std::string& edit)
{
    return run("cd $(mktemp -d) && trap 'rm -rf \"$PWD\"' EXIT && cp -r '" DIOPTRE_SOURCE_DIR
               "/glsl' g && sed -i '" +
               edit + "' g/" + file + " && ! cmp -s g/" + file + " '" DIOPTRE_SOURCE_DIR "/glsl/" + file +
               "' && DIOPTRE_GLSL=$PWD/g dioptre doctor --backend egl-surfaceless");
}

void expectSays(const std::string& text, const std::vector<std::string>& fragments)
{
    for (const auto& fragment : fragments)
        EXPECT_NE(text.find(fragment), std::string::npos) << "'" << fragment << "' not in\n" << text;
}

} // namespace

TEST(DoctorCommand, Backends_AreEachTriedAndTheFirstThatWorksIsTaken)
{
    const auto json = findings("dioptre doctor --json");
    std::vector<std::string> names;
    std::string first;
    for (const auto& attempt : json["backends"]) {
        names.push_back(attempt["backend"]);
        if (attempt["works"] && first.empty() && attempt["backend"] != "window")
            first = attempt["backend"];
        if (attempt["works"]) {
            EXPECT_FALSE(attempt["renderer"].get<std::string>().empty());
            EXPECT_GE(std::stod(attempt["version"].get<std::string>()), 3.3);
            EXPECT_GE(std::stod(attempt["glsl"].get<std::string>()), 3.3);
            EXPECT_GT(attempt["context_ms"].get<double>(), 0.0);
        } else {
            EXPECT_FALSE(attempt["fault"].get<std::string>().empty());
        }
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"egl-surfaceless", "egl-device", "egl-default", "osmesa", "window"}));
    EXPECT_EQ(json["backend"], first);
}

TEST(DoctorCommand, Json_HoldsWhatLlvmpipeIsKnownFor)
{
    const auto json = findings("dioptre doctor --json --backend egl-surfaceless");
    if (json["renderer"].get<std::string>().find("llvmpipe") == std::string::npos)
        GTEST_SKIP() << "the figures are llvmpipe's";
    EXPECT_EQ(json["backends"].size(), 1U);
    EXPECT_EQ(json["software"], true);
    EXPECT_EQ(json["limits"]["float_target"], true);
    EXPECT_GE(json["limits"]["texture_side_px"], 1024);
    EXPECT_EQ(json["clock"]["use"], "glFinish and the monotonic clock");
    EXPECT_EQ(json["float_sums"]["right"], true);
    EXPECT_EQ(json["loops"]["cap"], 65535);
    EXPECT_EQ(json["loops"]["most_per_sample"], 65535);
    EXPECT_LT(json["loops"]["of_two"]["ran"][1], json["loops"]["of_two"]["asked"]);
    const auto& arithmetic = json["arithmetic"];
    EXPECT_EQ(arithmetic["two_sum"]["plain"]["tested"], 65536);
    EXPECT_GT(arithmetic["two_sum"]["plain"]["wrong"], 0);
    EXPECT_EQ(arithmetic["two_sum"]["precise"]["wrong"], 0);
    EXPECT_EQ(arithmetic["two_sum"]["uniform"]["wrong"], 0);
    EXPECT_EQ(arithmetic["two_product"]["plain"]["wrong"], 0);
    EXPECT_EQ(arithmetic["guard"], "precise");
    EXPECT_EQ(arithmetic["normalize_1e20"], 0.0);
    EXPECT_EQ(arithmetic["normalize_1e-20"], "inf") << "JSON has no infinity: a string stands for it";
    EXPECT_EQ(json["verdict"]["exit_code"], 0);
}

TEST(DoctorCommand, Environment_TellsOfCacheAndThreads)
{
    const std::string variables = "cd $(mktemp -d); trap 'rm -rf \"$PWD\"' EXIT; export LP_NUM_THREADS=3 "
                                  "MESA_SHADER_CACHE_DIR=$PWD; ";
    const auto on = findings(variables + "dioptre doctor --json --backend egl-surfaceless")["environment"];
    EXPECT_EQ(on["shader_cache"], "on");
    EXPECT_EQ(on["raster_threads"], 3);
    EXPECT_EQ(on["lp_num_threads"], "3");
    EXPECT_GE(on["cores"], 1);
    const auto off = findings(
        variables + "MESA_SHADER_CACHE_DISABLE=true dioptre doctor --json --backend egl")["environment"];
    EXPECT_EQ(off["shader_cache"], "off");
    EXPECT_NE(off["shader_cache_reason"].get<std::string>().find("MESA_SHADER_CACHE_DISABLE"),
              std::string::npos);
}

TEST(DoctorCommand, Text_SaysWhatFollows)
{
    const Outcome outcome = run("dioptre doctor");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    expectSays(outcome.out,
               {"backends\n", "egl-surfaceless", "egl-device", "egl-default", "osmesa",
                "=> examined below: egl-surfaceless", "texture side", "=> loops ", "=> compensated kernels ",
                "=> bench times draws by glFinish", "LP_NUM_THREADS", "verdict: pictures can be drawn here"});
}

TEST(DoctorCommand, WithoutEglDrivers_ExaminesOsMesa)
{
    const auto json = findings("__EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre doctor --json");
    EXPECT_EQ(json["backend"], "osmesa");
    EXPECT_EQ(json["loops"]["cap"], 65535);
}

TEST(DoctorCommand, WithoutOpenGl_NamesEachAttemptAndTheMend)
{
    const std::string none = "__EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre doctor --backend egl";
    const Outcome text = run(none);
    EXPECT_EQ(text.code, 69);
    expectSays(text.out,
               {"egl-surfaceless", "egl-device", "egl-default", "fails: ", "verdict: no OpenGL", "install"});
    const Outcome json = run(none + " --json");
    EXPECT_EQ(json.code, 69);
    const auto parsed = nlohmann::json::parse(json.out);
    EXPECT_EQ(parsed["backends"].size(), 3U);
    EXPECT_EQ(parsed["verdict"]["exit_code"], 69);
    EXPECT_FALSE(parsed.contains("limits"));
}

// Drivers that crash are played by one that is no driver.
TEST(DoctorCommand, ADriverThatEndsTheProcess_IsAFinding)
{
    const Outcome outcome =
        run("cd $(mktemp -d) && trap 'rm -rf \"$PWD\"' EXIT && echo '#include "
            "<stdlib.h>\n__attribute__((constructor)) "
            "static void fall(void) { abort(); }' >f.c && cc -shared -fPIC f.c -o libEGL_fall.so && printf "
            "'{\"file_format_version\":\"1.0.0\",\"ICD\":{\"library_path\":\"%s/libEGL_fall.so\"}}' \"$PWD\" "
            ">fall.json && "
            "__EGL_VENDOR_LIBRARY_FILENAMES=$PWD/fall.json dioptre doctor");
    expectSays(outcome.out,
               {"the driver crashes (Aborted)", "name another --backend", "examined below: osmesa"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
}

TEST(DoctorCommand, LoopsThatEndTooSoon_FailTheCheck)
{
    const Outcome outcome = withEdited("probe/loops.frag", "s/i < limit;/i < limit \\&\\& i < 1000;/");
    EXPECT_EQ(outcome.code, 1) << outcome.error;
    expectSays(outcome.out,
               {"loops end silently after 1000", "verdict: pictures drawn here may be wrong", "65535"});
}

TEST(DoctorCommand, LoopsThatOnlyCount_FailTheCheck)
{
    const Outcome outcome = withEdited("probe/loops.frag", "s/return 1664525u/return 1664527u/");
    EXPECT_EQ(outcome.code, 1) << outcome.error;
    expectSays(outcome.out, {"loops do not compute what they should"});
}

TEST(DoctorCommand, SamplesThatDoNotAddUp_FailTheCheck)
{
    const Outcome outcome = withEdited("probe/add.frag", "s/= u_addend;/= 1.001 * u_addend;/");
    EXPECT_EQ(outcome.code, 1) << outcome.error;
    expectSays(outcome.out, {"samples do not add up"});
}

// Compensated kernels only go off: pictures come out without them.
TEST(DoctorCommand, ArithmeticThatIsNotExact_IsToldAndPasses)
{
    const Outcome outcome =
        withEdited("kernel/exact.glsl", "s/return vec2(sum, error);/return vec2(sum, 0.0);/");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    expectSays(outcome.out, {"=> compensated kernels are off"});
}

TEST(DoctorCommand, UnknownBackend_IsUsage)
{
    EXPECT_EQ(run("dioptre doctor --backend vulkan").code, 2);
}
