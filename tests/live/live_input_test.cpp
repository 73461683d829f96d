// What a name on the command line or a dropped file is taken for.
#include "live/live_input.h"

#include "base/error.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dioptre::test
{
namespace
{

class LiveInputs : public InAFolder
{
protected:
    std::string made(const std::string& name) const
    {
        std::ofstream(folder / name) << "x";
        return (folder / name).string();
    }
    static void expectMissing(const std::string& text)
    {
        try {
            findLiveInput(text);
            ADD_FAILURE() << text << " is taken for something";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::inputMissing) << text;
            EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
        }
    }
};

} // namespace

TEST_F(LiveInputs, Pictures_AreShownByAShaderOfOurOwn)
{
    for (const std::string name : {"a.png", "a.jpg", "a.jpeg", "A.PNG", "a.hdr", "a.exr", "a.EXR"}) {
        const std::string file = made(name);
        const LiveInput input = findLiveInput(file);
        EXPECT_TRUE(input.plainShader) << name;
        EXPECT_EQ(input.picture, file);
        EXPECT_EQ(input.shownFile(), std::filesystem::path(file));
        EXPECT_NE(input.path, input.shownFile());
        EXPECT_TRUE(std::filesystem::is_regular_file(input.path)) << input.path;
        EXPECT_EQ(input.name, std::filesystem::path(name).stem().string());
    }
}

TEST_F(LiveInputs, RadianceAndExr_HoldRadiance_TheOthersDoNot)
{
    for (const std::string name : {"a.hdr", "a.exr", "a.EXR"})
        EXPECT_TRUE(findLiveInput(made(name)).isLinear) << name;
    for (const std::string name : {"a.png", "a.jpg", "a.JPEG"})
        EXPECT_FALSE(findLiveInput(made(name)).isLinear) << name;
}

TEST_F(LiveInputs, ScenesAndShaders_AreThemselves)
{
    const LiveInput scene = findLiveInput(made("a.toml"));
    EXPECT_FALSE(scene.plainShader);
    EXPECT_TRUE(scene.picture.empty());
    EXPECT_EQ(scene.shownFile(), folder / "a.toml");
    const LiveInput shader = findLiveInput(made("a.frag"));
    EXPECT_TRUE(shader.plainShader);
    EXPECT_TRUE(shader.picture.empty());
    EXPECT_EQ(shader.shownFile(), folder / "a.frag");
}

TEST_F(LiveInputs, GalleryNames_AreKnown)
{
    EXPECT_FALSE(findLiveInput("still_life").plainShader);
}

TEST_F(LiveInputs, WhatIsNotThere_IsMissing)
{
    expectMissing((folder / "none.png").string());
    expectMissing((folder / "none.exr").string());
    expectMissing((folder / "none.toml").string());
    std::filesystem::create_directory(folder / "folder.png");
    expectMissing((folder / "folder.png").string());
}

} // namespace dioptre::test
