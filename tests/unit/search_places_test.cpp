// Which files the names in a scene may lead to.
#include "base/search_places.h"

#include "scene/load.h"
#include "scene/scene_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

namespace dioptre
{

namespace
{

namespace fs = std::filesystem;

// A scene's folder, a folder beside it, and the program's data, each with a picture.
class SearchPlacesTest : public testing::Test
{
protected:
    SearchPlacesTest() : root_(fs::temp_directory_path() / ("dioptre_search_" + std::to_string(getpid())))
    {
        for (const char* file : {"mine/own.png", "mine/below/deep.png", "beside/other.png",
                                 "program/textures/data.png", "program/glsl/trace/a.glsl"})
            add(file);
        places_.glslFolder = root_ / "program/glsl";
    }
    ~SearchPlacesTest() override
    {
        fs::remove_all(root_);
    }

    void add(const fs::path& file) const
    {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << "x";
    }

    // The file that a scene's picture of that name is, below the folder of all; what is thrown where it is
    // refused.
    std::string pictureNamed(const std::string& name, const std::vector<std::string>& overrides = {}) const
    {
        try {
            const Scene scene = parseScene("[material.a]\nimage = \"" + name + "\"\n", root_ / "mine/s.toml",
                                           overrides, 0.0, places_);
            return fs::path(scene.materials.at(0).image).lexically_relative(root_).string();
        } catch (const Error& error) {
            code_ = error.code();
            return std::string(error.what()).substr(root_.string().size() + 1);
        }
    }

    void expectRefused(const std::string& name) const
    {
        const std::string message = pictureNamed(name);
        EXPECT_TRUE(message.starts_with("mine/s.toml:2:9: \"" + name + "\" leads out of the scene's folder"))
            << message;
        EXPECT_NE(message.find("move it beside the scene, or name its folder by --include FOLDER"),
                  std::string::npos)
            << message;
        EXPECT_EQ(code_, ExitCode::badInput);
    }

    fs::path root_;
    SearchPlaces places_;
    mutable ExitCode code_ = ExitCode::done;
};

TEST_F(SearchPlacesTest, WithinTheScenesFolderAndTheProgramsData_IsTaken)
{
    EXPECT_EQ(pictureNamed("own.png"), "mine/own.png");
    EXPECT_EQ(pictureNamed("below/../below/deep.png"), "mine/below/deep.png");
    EXPECT_EQ(pictureNamed((root_ / "mine/own.png").string()), "mine/own.png");
    EXPECT_EQ(pictureNamed("data.png"), "program/textures/data.png");
    EXPECT_EQ(pictureNamed("../program/textures/data.png"), "program/textures/data.png");
    fs::create_symlink("below", root_ / "mine/link");
    EXPECT_EQ(pictureNamed("link/deep.png"), "mine/link/deep.png");
}

TEST_F(SearchPlacesTest, EachWayOut_IsRefused)
{
    expectRefused("../beside/other.png");
    expectRefused("below/../../beside/other.png");
    expectRefused((root_ / "beside/other.png").string());
    fs::create_symlink("../beside", root_ / "mine/link");
    expectRefused("link/other.png");
    fs::create_symlink("../beside/other.png", root_ / "mine/link.png");
    expectRefused("link.png");
    places_.glslFolder.clear();
    expectRefused("../program/textures/data.png");
}

TEST_F(SearchPlacesTest, FileOutsideThatIsNotThere_IsRefusedAlike)
{
    expectRefused("../beside/none.png");
    expectRefused("/nonexistent/none.png");
    EXPECT_NE(pictureNamed("none.png").find("no such file"), std::string::npos);
    EXPECT_EQ(code_, ExitCode::inputMissing);
}

TEST_F(SearchPlacesTest, FolderWhoseNameOnlyBeginsAsTheScenes_IsOutside)
{
    add("mine2/a.png");
    expectRefused("../mine2/a.png");
}

TEST_F(SearchPlacesTest, IncludedFolder_IsLookedInBehindTheScenesOwn)
{
    add("beside/own.png");
    add("third/other.png");
    places_.included = {root_ / "beside", root_ / "third"};
    EXPECT_EQ(pictureNamed("other.png"), "beside/other.png");
    EXPECT_EQ(pictureNamed("own.png"), "mine/own.png");
    EXPECT_EQ(pictureNamed("../beside/other.png"), "beside/other.png");
    places_.included = {root_ / "third/", root_ / "beside"};
    EXPECT_EQ(pictureNamed("other.png"), "third/other.png");
}

TEST_F(SearchPlacesTest, NameOfAnOverride_IsTheUsersOwn)
{
    const std::string file = (root_ / "beside/other.png").string();
    EXPECT_EQ(pictureNamed("own.png", {"material.a.image=" + file}), "beside/other.png");
}

TEST_F(SearchPlacesTest, PicturesNamedInAText_AreAllCandidates)
{
    places_.included = {root_ / "beside"};
    const auto files = picturesNamedIn("[sky]\nimage = [\"a.exr\", \"b/c.exr\"]\nmaterial = 3\n"
                                       "[material.m]\nimage = \"own.png\"\n",
                                       root_ / "mine/s.toml", places_);
    for (const char* file : {"mine/a.exr", "beside/a.exr", "program/textures/a.exr", "mine/b/c.exr",
                             "mine/own.png", "beside/own.png"})
        EXPECT_EQ(std::ranges::count(files, root_ / file), 1) << file;
    EXPECT_TRUE(picturesNamedIn("[sky\n", root_ / "mine/s.toml", places_).empty());
}

} // namespace

} // namespace dioptre
