// Whatever a scene mixes, its shader compiles and links, its uniforms are fed, its picture is finite, and
// both forms agree with double precision.
#include "kernel/reference.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/random_scene.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace dioptre;
using namespace dioptre::test;

TEST(RandomScenes, DrawOnTheDeviceAsInDoublePrecision)
{
    const char* full = std::getenv("DIOPTRE_FULL");
    const unsigned count = full != nullptr && std::string(full) == "yes" ? 400 : 40;
    for (unsigned seed = 1; seed <= count; ++seed) {
        const auto text = randomScene(seed);
        Picture twice;
        ASSERT_NO_THROW(twice = renderDoubleText(text, {24, 16, 1, {}, "auto", 0.35})) << text;
        for (const char* form : {"trace.form=literal", "trace.form=loop"}) {
            const Request request{24, 16, 1, {form}, "auto", 0.35};
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + form + "\n" + text);
            ASSERT_NO_THROW({
                const auto still = renderSceneText(text, request);
                EXPECT_EQ(still.counts.nonfinite, 0U);
                // Rays through random glass and mirrors multiply rounding; a fault of one feature shows on
                // whole areas.
                const auto difference = compare(still.picture, twice, 0.02);
                EXPECT_LE(difference.over, difference.pixels / 20)
                    << saveForTheEye("random-" + std::to_string(seed), still.picture, twice);
            });
        }
    }
}
