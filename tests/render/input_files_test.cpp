// What feeds a picture, the files that are not there included.
#include "render/input_files.h"

#include "base/file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

using namespace dioptre;

namespace
{

namespace fs = std::filesystem;

const fs::path glslOfSources = fs::path(DIOPTRE_SOURCE_DIR) / "glsl";

class InputFiles : public testing::Test
{
protected:
    InputFiles() : root_(fs::temp_directory_path() / ("dioptre_input_files_" + std::to_string(getpid())))
    {
        fs::create_directories(root_ / "more");
    }
    ~InputFiles() override
    {
        fs::remove_all(root_);
    }

    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(root_ / name) << text;
    }

    std::vector<fs::path> shaderFiles() const
    {
        return filesOfShader(root_ / "p.frag", {{root_ / "more"}, glslOfSources});
    }

    fs::path root_;
};

std::ptrdiff_t timesIn(const std::vector<fs::path>& files, const fs::path& file)
{
    return std::ranges::count(files, file);
}

} // namespace

TEST_F(InputFiles, OfAShader_AreItsIncludesAtAnyDepthAndWhereTheyMayLie)
{
    write("p.frag", "#include \"a.glsl\"\n#ifdef HAS_NONE\n#include \"kernel/ray.glsl\"\n#endif\n");
    write("more/a.glsl", "  # include \"b.glsl\" // deep\n#include bad\n");
    const auto files = shaderFiles();
    EXPECT_EQ(files.front(), root_ / "p.frag");
    for (const char* name : {"a.glsl", "b.glsl"})
        for (const fs::path& folder : {root_, root_ / "more", glslOfSources})
            EXPECT_EQ(timesIn(files, folder / name), 1) << folder << name;
    EXPECT_EQ(timesIn(files, glslOfSources / "kernel/ray.glsl"), 1);
}

TEST_F(InputFiles, OfCirclesFoldersAndWhatIsMissing_AreWhatCanBeTold)
{
    EXPECT_EQ(shaderFiles(), std::vector<fs::path>{root_ / "p.frag"});
    write("p.frag", "#include \"p.frag\"\n#include \"more\"\n#include \"a.glsl\"\n");
    write("a.glsl", "#include \"p.frag\"\n#include \"c.glsl\"\n");
    const auto files = shaderFiles();
    EXPECT_EQ(timesIn(files, root_ / "p.frag"), 1);
    EXPECT_EQ(timesIn(files, root_ / "c.glsl"), 1);
    EXPECT_EQ(timesIn(files, root_ / "more"), 1);
}

TEST_F(InputFiles, OfWhatLeadsOut_AreNotRead)
{
    fs::create_directories(root_ / "own");
    write("own/q.frag", "#include \"../out.glsl\"\n");
    write("out.glsl", "#include \"secret.glsl\"\n");
    const auto files = filesOfShader(root_ / "own/q.frag", {{}, glslOfSources});
    EXPECT_EQ(timesIn(files, root_ / "out.glsl"), 1);
    EXPECT_EQ(timesIn(files, root_ / "own/secret.glsl"), 0);
}

// Every file that some scene's shader takes from is among them.
TEST_F(InputFiles, OfAScene_AreItselfItsPicturesAndAllOfTheTracer)
{
    const fs::path scene = glslOfSources / "scenes" / "still_life.toml";
    const auto files = filesOfScene(scene, readFile(scene), {{}, glslOfSources});
    EXPECT_EQ(files.front(), scene);
    for (const char* folder : {"trace", "shared"})
        for (const auto& entry : fs::directory_iterator(glslOfSources / folder))
            EXPECT_EQ(timesIn(files, entry.path()), 1) << entry.path();
    const fs::path tracer = glslOfSources / "ray_trace.frag";
    EXPECT_EQ(timesIn(files, tracer), 1);
    // Some kernels are the stability suite's alone.
    for (const auto& entry : fs::directory_iterator(glslOfSources / "kernel")) {
        const bool isTracers =
            readFile(tracer).find("\"kernel/" + entry.path().filename().string() + "\"") != std::string::npos;
        EXPECT_EQ(timesIn(files, entry.path()), isTracers ? 1 : 0) << entry.path();
    }
    for (const char* picture : {"wave.png", "planet.png", "earth.jpg", "sky.exr"}) {
        EXPECT_EQ(timesIn(files, glslOfSources.parent_path() / "textures" / picture), 1) << picture;
        EXPECT_EQ(timesIn(files, glslOfSources / "scenes" / picture), 1) << picture;
    }
    EXPECT_TRUE(std::ranges::none_of(
        files, [](const fs::path& file) { return file.string().find("generated") != std::string::npos; }));
}

TEST_F(InputFiles, OfASceneThatIsNoToml_AreItselfAndTheTracer)
{
    const auto files = filesOfScene(root_ / "s.toml", "[sky\nimage = \"a.png\"\n", {{}, glslOfSources});
    EXPECT_EQ(files.front(), root_ / "s.toml");
    EXPECT_EQ(timesIn(files, glslOfSources / "trace/sky.glsl"), 1);
    EXPECT_EQ(timesIn(files, root_ / "a.png"), 0);
}
