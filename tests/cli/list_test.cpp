// What `dioptre list` names is what the other commands take.
#include "support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

using dioptre::test::run;

namespace
{

nlohmann::json listed()
{
    const auto outcome = run("dioptre list --json");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.out);
}

std::vector<std::string> namesOf(const nlohmann::json& rows)
{
    std::vector<std::string> names;
    for (const auto& row : rows)
        names.push_back(row["name"]);
    return names;
}

bool has(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

TEST(ListCommand, Scenes_AreTheGallerysWithTitleAndObjectCount)
{
    const auto scenes = listed()["scenes"];
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DIOPTRE_SOURCE_DIR "/glsl/scenes"))
        files += entry.path().extension() == ".toml" ? 1 : 0;
    EXPECT_EQ(scenes.size(), files);
    const auto stillLife = std::find_if(scenes.begin(), scenes.end(),
                                        [](const auto& scene) { return scene["name"] == "still_life"; });
    ASSERT_NE(stillLife, scenes.end());
    EXPECT_EQ((*stillLife)["title"], "Still life");
    EXPECT_EQ((*stillLife)["objects"], 10);
    for (const auto& scene : scenes)
        EXPECT_FALSE(scene.contains("fault")) << scene;
}

// The loader's refusal names every word that it knows: both must be the same.
TEST(ListCommand, OrdersFormsAndCurves_AreTheWordsThatTheLoaderTakes)
{
    const auto json = listed();
    for (const auto& [section, key] : {std::pair{"orders", "trace.order"},
                                       {"forms", "trace.form"},
                                       {"curves", "output.curve"},
                                       {"shadow_filters", "raster.shadow_filter"}}) {
        const auto names = namesOf(json[section]);
        EXPECT_GE(names.size(), 2U);
        const auto refusal =
            run(std::string("dioptre render cylinders --set ") + key + "=zzzzzzzz -o none.png");
        EXPECT_EQ(refusal.code, 65);
        std::string known;
        for (const auto& name : names)
            known += (known.empty() ? "" : ", ") + name;
        EXPECT_NE(refusal.error.find(known + "\n"), std::string::npos)
            << known << " not in " << refusal.error;
    }
}

TEST(ListCommand, Backends_AreTheWordsThatRenderTakes)
{
    const auto names = namesOf(listed()["backends"]);
    for (const char* name :
         {"auto", "egl", "egl-surfaceless", "egl-device", "egl-default", "osmesa", "window"})
        EXPECT_TRUE(has(names, name)) << name;
    const auto help = run("dioptre render --help").out;
    for (const auto& name : names)
        EXPECT_NE(help.find(name), std::string::npos) << name << " not in " << help;
}

TEST(ListCommand, Layers_AreTheWordsThatRenderTakes)
{
    std::string all;
    for (const auto& name : namesOf(listed()["layers"]))
        all += (all.empty() ? "" : ", ") + name;
    const auto refusal = run("dioptre render cylinders --layers zzzz -o none.exr");
    EXPECT_EQ(refusal.code, 2);
    EXPECT_NE(refusal.error.find("the layers are " + all + "\n"), std::string::npos) << refusal.error;
}

TEST(ListCommand, Text_HasOneLineForEachName)
{
    const auto out = run("dioptre list").out;
    for (const char* line :
         {"scenes\n", "orders\n", "forms\n", "views\n", "backends\n", "  heaviest-first  ", "10 objects\n"})
        EXPECT_NE(out.find(line), std::string::npos) << line << " not in\n" << out;
}

TEST(ListCommand, ASceneThatDoesNotLoad_IsListedWithTheReason)
{
    const auto outcome = run("cd $(mktemp -d) && trap 'rm -rf \"$PWD\"' EXIT && cp -r '" DIOPTRE_SOURCE_DIR
                             "/glsl' g && ln -s '" DIOPTRE_SOURCE_DIR
                             "/textures' textures && echo nonsense >g/scenes/aaa.toml && DIOPTRE_GLSL=$PWD/g "
                             "dioptre list --json");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto scenes = nlohmann::json::parse(outcome.out)["scenes"];
    EXPECT_EQ(scenes[0]["name"], "aaa");
    EXPECT_NE(scenes[0]["fault"].get<std::string>().find("aaa.toml:1"), std::string::npos) << scenes[0];
    EXPECT_GT(scenes[1]["objects"], 0);
}
