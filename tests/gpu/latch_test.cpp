// A latched scene has more in its shader than it needs, and draws the picture that it draws without.
#include "render/latch.h"
#include "render/renderer.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/random_scene.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// What is edited to and fro, and what is drawn at last.
struct Edits {
    std::string name;
    std::string scene; // of the gallery
    std::vector<std::vector<std::string>> before;
    std::vector<std::string> last;
};

void PrintTo(const Edits& edits, std::ostream* stream)
{
    *stream << edits.name;
}

ViewSettings settingsFor(int width, int height, DataView view)
{
    return {width, height, 1, glslFolder(), {}, view};
}

Rendered drawn(const Scene& scene, const ViewSettings& settings)
{
    return renderPrepared(prepare(scene, settings), settings, "auto");
}

// The same kernels on the same floats: only the compiler's folding of constants differs, so a few samples at
// edges, and a pool of 4 keeps rays that fall out of one of 3. The bounds of agreement_test.cpp.
void expectAlike(const std::string& name, const Picture& latched, const Picture& fresh)
{
    const auto difference = compare(latched, fresh, 0.01);
    std::cout << name << ": RMSE " << difference.rmse << ", " << difference.over << " of "
              << difference.pixels << " pixels over 0.01\n";
    EXPECT_LT(difference.rmse, 0.002) << saveForTheEye("latched-" + name, latched, fresh);
    EXPECT_LT(difference.over, difference.pixels / 200) << name;
}

class LatchedPicture : public testing::TestWithParam<Edits>
{
};

const std::vector<Edits> edits = {
    {"GlassThatIsNoLongerClear",
     "still_life",
     {{}},
     {"material.glass.transmit=0", "material.glass.absorption=[0,0,0]"}},
    {"GlassThatStillAbsorbs", "glass", {{}}, {"material.glass.transmit=0"}},
    {"GlassThatBecameAMirror", "still_life", {{}}, {"material.glass.mirror=1"}},
    {"MirrorThatIsNone", "still_life", {{}}, {"material.chrome.mirror=0", "material.lamp.mirror=0"}},
    {"MirrorsThatAreOneAndOneAgain",
     "still_life",
     {{"material.chrome.mirror=1"}, {"material.chrome.mirror=0.5"}},
     {"material.chrome.mirror=1"}},
    {"MatteSceneThatWasClear",
     "cylinders",
     {{"trace.depth=3", "material.cream.transmit=0.5", "material.red.mirror=0.4"},
      {"material.ochre.emission=[1,0,0]"}},
     {}},
    {"HighlightsThatAreGone",
     "still_life",
     {{}},
     {"material.frame.specular=[0,0,0]", "material.blue.specular=[0,0,0]"}},
    {"ShadowsThatAreOpaqueAgain", "glass", {{}}, {"material.glass.shadow=opaque"}},
    {"SeaThatIsNoLongerClear", "underwater", {{"animate=[]"}}, {"animate=[]", "material.water.transmit=0"}},
    {"BudgetThatIsOneAgain", "still_life", {{}}, {"trace.budget=1"}}};

INSTANTIATE_TEST_SUITE_P(Edits, LatchedPicture, testing::ValuesIn(edits),
                         [](const auto& info) { return info.param.name; });

} // namespace

TEST_P(LatchedPicture, IsTheOneOfTheSceneAsItIs)
{
    const auto path = glslFolder() / "scenes" / (GetParam().scene + ".toml");
    const Scene fresh = loadScene(path, GetParam().last, 0.0, places());
    Scene latched = loadScene(path, GetParam().before.front(), 0.0, places());
    for (const auto& overrides : GetParam().before) {
        Scene next = loadScene(path, overrides, 0.0, places());
        latch(next, latched);
        latched = std::move(next);
    }
    Scene last = fresh;
    latch(last, latched);
    ASSERT_EQ(last.typical.size(), 2U);
    const auto settings = settingsFor(160, 90, DataView::none);
    const auto a = drawn(last, settings);
    const auto b = drawn(fresh, settings);
    EXPECT_NE(flatten(a.shader), flatten(b.shader)) << "nothing is latched";
    expectAlike(GetParam().name, a.picture, b.picture);
}

namespace
{

// The scene with all that a material or a light may have.
std::vector<std::string> everythingOn(const Scene& scene)
{
    std::vector<std::string> overrides = {"animate=[]", "trace.depth=20", "trace.budget=40"};
    for (const auto& material : scene.materials)
        for (const char* value :
             {"mirror=0.3", "transmit=0.3", "ambient=[0.1,0.2,0.3]", "specular=[0.3,0.2,0.1]",
              "absorption=[0.1,0.2,0.3]", "emission=[0.3,0.2,0.1]", "ior=1.3"})
            overrides.push_back("material." + material.name + "." + value);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        overrides.push_back("light." + std::to_string(i) + ".ambient=[0.1,0.1,0.1]");
    return overrides;
}

class LatchedGallery : public testing::TestWithParam<std::filesystem::path>
{
};

INSTANTIATE_TEST_SUITE_P(Scenes, LatchedGallery, testing::ValuesIn(galleryScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

} // namespace

TEST_P(LatchedGallery, SceneThatHadEverything_DrawsItsOwnPicture)
{
    const Scene fresh = loadScene(GetParam(), {"animate=[]"}, 0.0, places());
    Scene latched = fresh;
    latch(latched, loadScene(GetParam(), everythingOn(fresh), 0.0, places()));
    const auto settings = settingsFor(160, 90, DataView::none);
    expectAlike("all-" + GetParam().stem().string(), drawn(latched, settings).picture,
                drawn(fresh, settings).picture);
}

TEST(LatchedPicture, OfRandomScenesThatHadEverything_IsTheirOwn)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto text = randomScene(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
        const auto path = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "text.toml";
        for (const char* form : {"trace.form=literal", "trace.form=loop"}) {
            const Scene fresh = parseScene(text, path, {"animate=[]", form}, 0.0, places());
            auto overrides = everythingOn(fresh);
            overrides.emplace_back(form);
            Scene latched = fresh;
            latch(latched, parseScene(text, path, overrides, 0.0, places()));
            ASSERT_EQ(latched.typical.size(), 2U);
            const auto settings = settingsFor(24, 16, DataView::none);
            expectAlike("random-" + std::to_string(seed), drawn(latched, settings).picture,
                        drawn(fresh, settings).picture);
        }
    }
}

namespace
{

// A lamp and the eye within a ball of m, which a wall of m cuts.
const std::string inABall = R"(
[camera]
eye = [0, 0.5, 2]
[[light]]
kind = "point"
position = [0, 2, 0]
[material.m]
colour = [0.8, 0.4, 0.2]
absorption = [0.1, 0.2, 0.3]
[material.n]
[[sphere]]
centre = [0, 0, 0]
radius = 4
material = "m"
[[cylinder]]
base = [1, -1, -1]
axis = [0, 1, 0]
radius = 0.5
capped = true
material = "m"
[[plane]]
point = [0, -1, 0]
normal = [0, 1, 0]
material = "m"
[[disk]]
centre = [-1, 0, 0]
normal = [0, 1, 0]
radius = 0.5
material = "n"
)";

} // namespace

// Light that never crosses a solid's surface is not in its shadow, whatever it once let through.
TEST(LatchedPicture, WithinAnOpaqueSolidThatWasClear_IsLit)
{
    for (const char* form : {"trace.form=literal", "trace.form=loop"}) {
        const auto edited = [&](const std::vector<std::string>& more) {
            std::vector<std::string> all = {form};
            all.insert(all.end(), more.begin(), more.end());
            return parseScene(inABall, "ball.toml", all, 0.0, places());
        };
        const Scene fresh = edited({});
        Scene latched = fresh;
        latch(latched, edited({"material.m.transmit=0.7"}));
        EXPECT_TRUE(makePlan(latched).has("tinted shadows"));
        const auto settings = settingsFor(96, 54, DataView::none);
        const auto picture = drawn(fresh, settings).picture;
        double brightest = 0.0;
        for (std::size_t i = 0; i < picture.floats.size(); i += 4)
            brightest = std::max<double>(brightest, picture.floats[i]);
        EXPECT_GT(brightest, 0.1);
        expectAlike(std::string("within, ") + form, drawn(latched, settings).picture, picture);
    }
}

// A budget is no part of the text of most trees: the same renderer goes on with it.
TEST(LatchedPicture, RendererGoesOnWithAnotherBudget)
{
    const auto path = glslFolder() / "scenes" / "glass.toml";
    const auto settings = settingsFor(64, 36, DataView::none);
    const auto& context = contextFor("auto");
    auto prepared = prepare(loadScene(path, {"trace.budget=2"}, 0.0, places()), settings);
    Renderer renderer(prepared, settings, context);
    Scene edited = loadScene(path, {"trace.budget=3000"}, 0.0, places());
    latch(edited, loadScene(path, {"trace.budget=2"}, 0.0, places()));
    moveTo(prepared, edited, settings);
    renderer.update(prepared);
    const auto still = drawStill(renderer, {0, 0, 64, 36});
    expectAlike("budget", still.picture,
                drawn(loadScene(path, {"trace.budget=3000"}, 0.0, places()), settings).picture);
    EXPECT_GT(still.counts.rays, 2.5 * 64 * 36);
}

// What the budget of a wider plan leaves room for is not counted as waiting.
TEST(LatchedPicture, LostWeight_IsThatOfTheScenesOwnBudget)
{
    const auto path = glslFolder() / "scenes" / "glass.toml";
    for (const char* order : {"trace.order=breadth-first", "trace.order=depth-first"}) {
        const Scene fresh = loadScene(path, {order, "trace.budget=3"}, 0.0, places());
        Scene latched = fresh;
        latch(latched, loadScene(path, {order, "trace.budget=30"}, 0.0, places()));
        const auto settings = settingsFor(64, 36, DataView::lost);
        expectAlike(std::string("lost, ") + order, drawn(latched, settings).picture,
                    drawn(fresh, settings).picture);
    }
}
