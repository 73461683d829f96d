// Data in place of light: each view shows what it says, by hand-derived numbers.
#include "render/view_picture.h"
#include "scene/load.h"
#include "support/glslang.h"
#include "support/random_scene.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

using Rgb = std::array<float, 3>;

Rgb at(const Picture& picture, int x, int y)
{
    const auto i = static_cast<std::size_t>(4 * (y * picture.width + x));
    return {picture.floats[i], picture.floats[i + 1], picture.floats[i + 2]};
}

void expectNear(const Rgb& actual, const Rgb& expected, float tolerance = 1.0e-5F)
{
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

Picture viewOf(const std::string& scene, DataView view, int side = 33, int samples = 1)
{
    return renderSceneText(scene, {side, side, samples, {}, "auto", 0.0, view}).picture;
}

// The view is 90 degrees: pixel x of 33 looks along ((2 x + 1) / 33 - 1, ..., -1).
const std::string camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 90\n";
const std::string ball = "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 1\n";
const std::string wall = "[[plane]]\npoint = [0, 0, -3]\nnormal = [0, 0, -1]\n";

} // namespace

TEST(NormalView, FacesTheEye_AndIsBlackForTheSky)
{
    const auto picture =
        viewOf(camera + ball + "[[plane]]\npoint = [0, -2, 0]\nnormal = [0, 1, 0]\n", DataView::normal);
    expectNear(at(picture, 16, 16), {0.5F, 0.5F, 1.0F});
    expectNear(at(picture, 16, 0), {0.5F, 1.0F, 0.5F});
    expectNear(at(picture, 16, 32), {0.0F, 0.0F, 0.0F});
    // A wall seen from behind, and a ball from within.
    expectNear(at(viewOf(camera + wall, DataView::normal), 3, 3), {0.5F, 0.5F, 1.0F});
    const auto within = viewOf("[camera]\neye = [0, 0, 0]\ntarget = [1, 0, 0]\n" + ball, DataView::normal);
    expectNear(at(within, 16, 16), {0.0F, 0.5F, 0.5F});
}

TEST(DepthView, IsMetresAlongTheRay)
{
    const auto picture = viewOf(camera + ball + wall, DataView::depth);
    expectNear(at(picture, 16, 16), {4.0F, 4.0F, 4.0F});
    // The wall is 8 m away, and the last column looks 32/33 to the side for each metre ahead.
    const float slant = 8.0F * std::sqrt(1.0F + (32.0F / 33.0F) * (32.0F / 33.0F));
    expectNear(at(picture, 32, 16), {slant, slant, slant});
}

TEST(DepthView, AtAnEdgeToTheSky_IsThatOfWhatIsThere)
{
    // The ball's surface is seen from 4 m to the tangent's sqrt(24) m.
    const auto picture = viewOf(camera + ball, DataView::depth, 33, 16);
    std::size_t met = 0;
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) {
            const float depth = at(picture, x, y)[0];
            EXPECT_TRUE(depth == 0.0F || (depth > 3.999F && depth < 4.9F)) << depth;
            met += depth > 0.0F ? 1 : 0;
        }
    EXPECT_GT(met, 20U);
    EXPECT_LT(met, 33U * 33U);
}

TEST(ObjectView, ShowsEachObjectInItsLegendsColour)
{
    const auto picture = viewOf(camera + ball + wall, DataView::object);
    for (const auto& [x, object] : {std::pair{16, 0U}, std::pair{2, 1U}}) {
        const auto [red, green, blue] = objectColour(object);
        expectNear(at(picture, x, 16), {static_cast<float>(red) / 255.0F, static_cast<float>(green) / 255.0F,
                                        static_cast<float>(blue) / 255.0F});
    }
    expectNear(at(viewOf(camera + ball, DataView::object), 2, 16), {0.0F, 0.0F, 0.0F});
}

TEST(UvView, CountsAlongARectanglesEdges)
{
    const auto picture =
        viewOf("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nfov_y_deg = 90\n"
               "[[rectangle]]\ncorner = [-1, -1, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 2, 0]\n",
               DataView::uv, 4);
    expectNear(at(picture, 0, 0), {0.125F, 0.125F, 0.0F});
    expectNear(at(picture, 3, 1), {0.875F, 0.375F, 0.0F});
}

TEST(UvView, HasCoordinatesOnShapesThatWearNothing)
{
    // Longitude 0 lies along +z; the middle of height and disk are halves.
    expectNear(at(viewOf(camera + ball, DataView::uv), 16, 16), {0.5F, 0.5F, 0.0F});
    expectNear(
        at(viewOf(camera + "[[cylinder]]\nbase = [0, -1, 0]\naxis = [0, 2, 0]\nradius = 1\n", DataView::uv),
           16, 16),
        {0.5F, 0.5F, 0.0F});
    expectNear(
        at(viewOf(camera + "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 1\n", DataView::uv),
           16, 16),
        {0.5F, 0.5F, 0.0F});
    // The ray meets the floor at (0, 0, -1), 0.25 m right of and 1.5 m beyond the point; a picture spans 2 m.
    expectNear(at(viewOf("[camera]\neye = [0, 1, 0]\ntarget = [0, 0, -1]\n[material.m]\nimage = "
                         "\"wave.png\"\nsize = 2.0\n"
                         "[[plane]]\npoint = [-0.25, 0, 0.5]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n",
                         DataView::uv),
                  16, 16),
               {0.125F, 0.75F, 0.0F});
}

TEST(RaysView, CountsTheEyeRayAndWhatAMirrorSendsOn)
{
    const std::string chrome = "[material.chrome]\nmirror = 1.0\n";
    const auto picture = viewOf(chrome + camera + ball + "material = \"chrome\"\n", DataView::rays);
    expectNear(at(picture, 16, 16), {2.0F, 2.0F, 2.0F});
    expectNear(at(picture, 0, 0), {1.0F, 1.0F, 1.0F});
    expectNear(at(viewOf(camera + ball, DataView::rays), 16, 16), {1.0F, 1.0F, 1.0F});
}

TEST(RaysView, CountsTheRaysOfThePicture)
{
    // With a bright sky, which lowers the weight that is cut, although the view does not look at the sky.
    for (const char* order : {"heaviest-first", "breadth-first", "depth-first"}) {
        const auto scene = glslFolder() / "scenes" / "still_life.toml";
        Request request{64, 36, 1, ownPictures(scene), "auto"};
        request.overrides.push_back(std::string("trace.order=") + order);
        const double rays = renderScene(scene, request).raysPerSample;
        request.view = DataView::rays;
        const auto counted = renderScene(scene, request);
        double sum = 0.0;
        for (std::size_t i = 0; i < counted.picture.floats.size(); i += 4)
            sum += static_cast<double>(counted.picture.floats[i]);
        EXPECT_NEAR(sum / (64.0 * 36.0), rays, 0.01) << order;
        EXPECT_TRUE(counted.textures.empty()) << "no light, no pictures";
    }
}

namespace
{

// The eye stands between two mirrors that face each other; what they do not mirror is black.
std::string hall(const std::string& trace, const std::string& mirror)
{
    return "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n[trace]\n" + trace +
           "[material.m]\ncolour = [0, 0, 0]\nmirror = " + mirror +
           "\n[[plane]]\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\nmaterial = \"m\"\n"
           "[[plane]]\npoint = [0, 0, 1]\nnormal = [0, 0, -1]\nmaterial = \"m\"\n";
}

const std::vector<std::string> orders = {"order = \"heaviest-first\"\n", "order = \"breadth-first\"\n",
                                         "order = \"depth-first\"\n"};

} // namespace

TEST(LostView, BetweenFullMirrors_AllWeightIsLostToTheBudget)
{
    for (const auto& order : orders)
        for (const char* budget : {"budget = 1\n", "budget = 5\n"}) {
            SCOPED_TRACE(order + budget);
            expectNear(at(viewOf(hall(order + budget, "1.0"), DataView::lost, 3), 1, 1), {0.0F, 0.0F, 1.0F});
        }
}

TEST(LostView, BetweenHalfMirrors_TheFirstWeightBelowTheCutOffIsLostToIt)
{
    // 1/2, 1/4, 1/8 go on; 1/16 is below 0.1.
    for (const auto& order : orders) {
        SCOPED_TRACE(order);
        expectNear(at(viewOf(hall(order + "cut_off = 0.1\n", "0.5"), DataView::lost, 3), 1, 1),
                   {0.0625F, 0.0F, 0.0F});
    }
}

TEST(LostView, BeyondTheDepthLimit_CountsWithTheBudget)
{
    // Three bounces go on; the fourth would carry 1/16.
    for (const auto& order : orders) {
        SCOPED_TRACE(order);
        expectNear(at(viewOf(hall(order + "depth = 3\n", "0.5"), DataView::lost, 3), 1, 1),
                   {0.0F, 0.0F, 0.0625F});
    }
}

TEST(LostView, WhereNothingIsSentOn_IsBlack)
{
    expectNear(at(viewOf(camera + ball, DataView::lost), 16, 16), {0.0F, 0.0F, 0.0F});
    expectNear(at(viewOf(camera, DataView::lost), 16, 16), {0.0F, 0.0F, 0.0F});
}

TEST(LostView, AndTheLightOfAWhiteWorld_MakeOne)
{
    // All that ends in the white sky, or on a white surface in white ambient light, arrives as 1.
    const std::string furnace =
        "[camera]\neye = [0, 0.2, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 30\n[sky]\ncolour = [1, 1, 1]\n"
        "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"
        "[material.glass]\nior = 1.5\ntransmit = 1.0\nmirror = 0.2\n"
        "[material.inner]\nior = 1.2\ntransmit = 0.7\noutside = \"glass\"\n[material.half]\nmirror = 0.5\n"
        "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n"
        "[[sphere]]\ncentre = [0.1, 0, 0.2]\nradius = 0.5\nmaterial = \"inner\"\n"
        "[[plane]]\npoint = [0, -1.1, 0]\nnormal = [0, 1, 0]\nmaterial = \"half\"\n";
    for (const auto& order : orders)
        for (const char* limits :
             {"budget = 1\n", "budget = 5\n", "budget = 24\ncut_off = 0.001\n", "budget = 24\ndepth = 4\n"}) {
            SCOPED_TRACE(order + limits);
            const auto scene = "[trace]\n" + order + limits + furnace;
            const auto light = viewOf(scene, DataView::none, 24);
            const auto lost = viewOf(scene, DataView::lost, 24);
            float fallen = 0.0F;
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x) {
                    const auto [cut, pool, budget] = at(lost, x, y);
                    EXPECT_NEAR(at(light, x, y)[0] + cut + pool + budget, 1.0F, 1.0e-4F) << x << ", " << y;
                    fallen += pool;
                }
            const bool pooled =
                order == orders.front() && std::string(limits).find("24") != std::string::npos;
            EXPECT_EQ(fallen > 0.0F, pooled) << "only a pool loses what does not fit";
        }
}

TEST(Views, OfEveryGalleryScene_AreValidShaders_AndFedWhatTheyRead)
{
    for (const auto& scene : galleryScenes()) {
        std::map<std::string, std::string> shaders; // each validated, in one run of the validator
        for (const auto view : {DataView::lost, DataView::object, DataView::normal, DataView::depth,
                                DataView::uv, DataView::trust})
            for (const std::vector<std::string>& overrides :
                 {std::vector<std::string>{}, {"trace.form=loop"}, {"plan.values=uniforms"}}) {
                const auto how =
                    std::string(rowOf(view).name) + (overrides.empty() ? "" : " " + overrides.front());
                SCOPED_TRACE(scene.string() + " " + how);
                Rendered still;
                ASSERT_NO_THROW(still = test::renderScene(scene, {16, 9, 1, overrides, "auto", 0.0, view}));
                EXPECT_TRUE(still.textures.empty());
                EXPECT_EQ(still.counts.nonfinite, 0U);
                shaders[how + ".frag"] = flatten(still.shader);
            }
        EXPECT_EQ(complaints(shaders), "") << scene;
    }
}

TEST(Views, OfRandomScenes_AreFedWhatTheyRead)
{
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const auto text = randomScene(seed);
        for (const auto view : {DataView::lost, DataView::object, DataView::normal, DataView::depth,
                                DataView::uv, DataView::trust}) {
            SCOPED_TRACE(std::string(rowOf(view).name) + " of seed " + std::to_string(seed) + "\n" + text);
            const char* form = seed % 2 == 0 ? "trace.form=literal" : "trace.form=loop";
            ASSERT_NO_THROW(
                EXPECT_EQ(renderSceneText(text, {8, 6, 1, {form}, "auto", 0.0, view}).counts.nonfinite, 0U));
        }
    }
}
