// There is one tracer: an edit of one line of glsl/ changes the device's picture and the reference's alike.
// This program is built with a reference compiled from edited sources; see CMakeLists.txt for the line.
#include "support/compare.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace dioptre;
using namespace dioptre::test;

TEST(EditedShader, ChangesThePictureOnTheDeviceAndInDoublePrecisionAlike)
{
    const auto scene = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "still_life.toml";
    const Request request{96, 54, 1, {}, "auto"};
    const auto original = test::renderScene(scene, request).picture;
    const auto editedInDouble = renderDouble(scene, request);
    setenv("DIOPTRE_GLSL", DIOPTRE_EDITED_GLSL, 1);
    const auto editedOnDevice = test::renderScene(scene, request).picture;
    EXPECT_GT(compare(editedOnDevice, original, 0.01).rmse, 0.05) << "the device did not follow the edit";
    EXPECT_GT(compare(editedInDouble, original, 0.01).rmse, 0.05) << "the reference did not follow the edit";
    // As in the agreement of the unedited gallery.
    EXPECT_LT(compare(editedOnDevice, editedInDouble, 0.01).rmse, 0.006)
        << saveForTheEye("edited", editedOnDevice, editedInDouble);
}
