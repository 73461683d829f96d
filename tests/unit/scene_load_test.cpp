// What a good scene file becomes.
#include "scene/camera.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace dioptre
{

namespace
{

namespace fs = std::filesystem;

// A folder of empty files, laid out like the gallery, and removed at the end.
class Gallery
{
public:
    Gallery() : root_(fs::temp_directory_path() / ("dioptre_scene_load_" + std::to_string(getpid())))
    {
        fs::create_directories(root_ / "glsl/scenes");
        fs::create_directories(root_ / "textures");
    }
    Gallery(const Gallery&) = delete;
    Gallery& operator=(const Gallery&) = delete;
    ~Gallery()
    {
        fs::remove_all(root_);
    }

    fs::path add(const fs::path& name, const std::string& text = "") const
    {
        std::ofstream(root_ / name) << text;
        return root_ / name;
    }
    fs::path scene() const
    {
        return root_ / "glsl/scenes/a.toml";
    }
    SearchPlaces places() const
    {
        return {{}, root_ / "glsl"};
    }

private:
    fs::path root_;
};

// The example of the design, less its animation.
const char* const stillLife = R"(title = "Still life"
[camera]
eye = [0.0, 1.6, 5.0]
target = [0.0, 0.9, 0.0]
fov_y_deg = 42.0
[sky]
image = "sky.hdr"
[trace]
budget = 16
[material.glass]
ior = 1.52
transmit = 1.0
absorption = [0.1, 0.02, 0.05]
[material.wave]
image = "wave.png"
[material.floor]
pattern = "checker"
colours = [[0.8, 0.8, 0.8], [0.2, 0.2, 0.25]]
size = 1.0
[[light]]
kind = "point"
position = [2.0, 4.0, 3.0]
diffuse = [1.0, 1.0, 1.0]
attenuation = [1.0, 0.0, 0.0]
[[sphere]]
name = "ball"
centre = [0.0, 1.0, 0.0]
radius = 1.0
material = "glass"
)";

TEST(Scene, StillLifeOfTheDesign_KeepsEveryValue)
{
    const Gallery gallery;
    const fs::path wave = gallery.add("textures/wave.png");
    const fs::path sky = gallery.add("glsl/scenes/sky.hdr");
    const fs::path path = gallery.add("glsl/scenes/a.toml", stillLife);
    const Scene scene = loadScene(path, {}, 0.0, gallery.places());

    EXPECT_EQ(scene.path, path.string());
    EXPECT_EQ(scene.title, "Still life");
    EXPECT_EQ(scene.camera.eye, glm::dvec3(0.0, 1.6, 5.0));
    EXPECT_EQ(scene.camera.target, glm::dvec3(0.0, 0.9, 0.0));
    EXPECT_EQ(scene.camera.fovY_deg, 42.0);
    EXPECT_FALSE(scene.camera.inside);
    EXPECT_EQ(scene.sky.kind, Sky::Kind::image);
    EXPECT_EQ(scene.sky.image, sky.string());
    EXPECT_EQ(scene.trace.budget, 16);
    EXPECT_FALSE(scene.trace.depth);

    ASSERT_EQ(scene.materials.size(), 3u);
    const Material& glass = scene.materials[0];
    EXPECT_EQ(glass.name, "glass");
    EXPECT_EQ(glass.ior, 1.52);
    EXPECT_EQ(glass.transmit, 1.0);
    EXPECT_EQ(glass.absorption, glm::dvec3(0.1, 0.02, 0.05));
    EXPECT_EQ(glass.shadow, ShadowKind::tinted);
    EXPECT_EQ(scene.materials[1].name, "wave");
    EXPECT_EQ(scene.materials[1].image, wave.string());
    EXPECT_EQ(scene.materials[1].shadow, ShadowKind::opaque);
    ASSERT_TRUE(scene.materials[2].checker);
    EXPECT_EQ(scene.materials[2].checker->colours[1], glm::dvec3(0.2, 0.2, 0.25));
    EXPECT_EQ(scene.materials[2].checker->size, 1.0);

    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, Light::Kind::point);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(2.0, 4.0, 3.0));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].name, "ball");
    EXPECT_EQ(scene.objects[0].material, 0u);
    EXPECT_EQ(scene.objects[0].where.line, 25);
    EXPECT_EQ(std::get<Sphere>(scene.objects[0].primitive).centre, glm::dvec3(0.0, 1.0, 0.0));
}

TEST(Scene, EmptyFile_IsADefaultSceneWithoutObjects)
{
    const Scene scene = parseScene("", "a.toml");
    EXPECT_TRUE(scene.objects.empty());
    EXPECT_TRUE(scene.materials.empty());
    EXPECT_EQ(scene.sky.kind, Sky::Kind::colour);
    EXPECT_EQ(scene.sky.colour, glm::dvec3(0.0));
}

TEST(Scene, MissingFile_IsInputMissing)
{
    try {
        loadScene("/nonexistent/a.toml");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::inputMissing);
    }
}

TEST(Scene, ObjectsOfMixedKinds_AreNumberedInFileOrder)
{
    const Scene scene = parseScene(R"(
[[triangle]]
name = "t"
a = [0, 0, 0]
b = [1, 0, 0]
c = [0, 1, 0]
[[sphere]]
name = "s0"
centre = [0, 0, 0]
radius = 1
[[rectangle]]
name = "r"
corner = [0, 0, 0]
edge_u = [1, 0, 0]
edge_v = [0, 1e-6, 0]
[[sphere]]
name = "s1"
centre = [0, 0, 0]
radius = 1
[[cylinder]]
name = "c"
base = [0, 0, 0]
axis = [0, 2, 0]
radius = 1
capped = true
rotate_texture_deg = 90
[[disk]]
name = "d"
centre = [0, 0, 0]
normal = [0, 1, 0]
radius = 1
[[plane]]
name = "p"
point = [0, 0, 0]
normal = [0, 3, 0]
)",
                                   "a.toml");
    std::string names;
    for (const Object& object : scene.objects)
        names += object.name + " ";
    EXPECT_EQ(names, "t s0 r s1 c d p ");
    EXPECT_TRUE(std::get<Cylinder>(scene.objects[4].primitive).capped);
    EXPECT_EQ(scene.objects[4].rotateTexture_deg, 90.0);
    EXPECT_EQ(std::get<Plane>(scene.objects[6].primitive).normal, glm::dvec3(0.0, 3.0, 0.0));
}

TEST(Scene, ObjectsWithoutMaterial_ShareOneWhiteLambertMaterial)
{
    const char* text = "[material.a]\nmirror = 1\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                       "[[sphere]]\ncentre = [0, 0, 0]\nradius = 2\n";
    const Scene scene = parseScene(text, "a.toml");
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[1].name, "default");
    EXPECT_EQ(scene.materials[1].colour, glm::dvec3(1.0));
    EXPECT_EQ(scene.materials[1].model, ReflectanceModel::lambert);
    EXPECT_EQ(scene.objects[0].material, 1u);
    EXPECT_EQ(scene.objects[1].material, 1u);
}

TEST(Scene, MaterialCalledDefault_IsTakenByObjectsThatNameNone)
{
    const char* text =
        "[material.a]\n[material.default]\nmirror = 1\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
    const Scene scene = parseScene(text, "a.toml");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.objects[0].material, 1u);
}

TEST(Scene, EveryTraceAndSkyKey_ReachesItsField)
{
    const Gallery gallery;
    gallery.add("textures/sky.hdr");
    const Scene scene = parseScene(R"([trace]
budget = 8
depth = 0
cut_off = 0
order = "breadth-first"
form = "loop"
light_type = 2
[sky]
image = "sky.hdr"
encoding = "linear"
rotation_deg = -30
mirror_u = true
exposure = -1.5
[camera]
inside = "sea"
[material.sea]
)",
                                   gallery.scene(), {}, 0.0, gallery.places());
    EXPECT_EQ(scene.trace.budget, 8);
    EXPECT_EQ(scene.trace.depth, 0);
    EXPECT_EQ(scene.trace.cutOff, 0.0);
    EXPECT_EQ(scene.trace.order, TreeOrder::breadthFirst);
    EXPECT_EQ(scene.trace.form, SceneForm::loop);
    EXPECT_EQ(scene.trace.lightType, LightType::lightsOnly);
    EXPECT_EQ(scene.sky.encoding, Encoding::linear);
    EXPECT_EQ(scene.sky.rotation_deg, -30.0);
    EXPECT_TRUE(scene.sky.mirrorU);
    EXPECT_EQ(scene.sky.exposure, -1.5);
    EXPECT_EQ(scene.camera.inside, 0u);
}

TEST(Scene, PictureBesideTheScene_IsTakenBeforeTheGallerysTextures)
{
    const Gallery gallery;
    gallery.add("textures/a.png");
    const fs::path beside = gallery.add("glsl/scenes/a.png");
    const Scene scene =
        parseScene("[material.a]\nimage = \"a.png\"\n", gallery.scene(), {}, 0.0, gallery.places());
    EXPECT_EQ(scene.materials[0].image, beside.string());
}

TEST(Scene, ListOfPictures_TakesTheFirstThatExists)
{
    const Gallery gallery;
    const fs::path second = gallery.add("textures/planet.png");
    gallery.add("textures/third.png");
    const Scene scene =
        parseScene("[material.a]\nimage = [\"no_earth.jpg\", \"planet.png\", \"third.png\"]\n",
                   gallery.scene(), {}, 0.0, gallery.places());
    EXPECT_EQ(scene.materials[0].image, second.string());
}

TEST(Scene, ChainOfMediaWithoutACircle_IsAccepted)
{
    const Scene scene =
        parseScene("[material.a]\noutside = \"b\"\n[material.b]\noutside = \"c\"\n[material.c]\n"
                   "[material.d]\noutside = \"c\"\n",
                   "a.toml");
    EXPECT_EQ(scene.materials[3].outside, 2u);
}

TEST(Scene, TinyAndHugeShapes_AreAcceptedForTheyAreOnlyScaled)
{
    for (const char* size : {"1e-15", "1e15"}) {
        const std::string s = size;
        const std::string text = "[[triangle]]\na = [0, 0, 0]\nb = [" + s + ", 0, 0]\nc = [0, " + s +
                                 ", 0]\n" + "[camera]\neye = [0, 0, " + s + "]\ntarget = [0, 0, 0]\n";
        EXPECT_NO_THROW(parseScene(text, "a.toml")) << s;
    }
}

} // namespace

} // namespace dioptre
