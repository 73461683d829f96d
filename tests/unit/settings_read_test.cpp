#include "base/file.h"
#include "base/picture.h"
#include "picture_fixture.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

using SettingsInAFile = PictureFile;

// Beyond ASCII too; a PNG holds that in another kind of chunk.
const Settings settings = {{"dioptre.time", "0.25"}, {"dioptre.set", "title=Sch\xC3\xB6n"}};

} // namespace

TEST_F(SettingsInAFile, OfAPng_AreReadBack)
{
    writePng(folder_ / "a.png", floatPicture(1, 1, {0, 0, 0, 1}), {}, settings);
    EXPECT_EQ(readSettings(folder_ / "a.png"), settings);
}

TEST_F(SettingsInAFile, OfAnExr_AreReadBack)
{
    writeExr(folder_ / "a.exr", floatPicture(1, 1, {0, 0, 0, 1}), ExrDepth::half, settings);
    EXPECT_EQ(readSettings(folder_ / "a.exr"), settings);
}

TEST_F(SettingsInAFile, OfWhatIsMissingOrBroken_AreNone)
{
    EXPECT_TRUE(readSettings(folder_ / "nowhere.png").empty());
    EXPECT_TRUE(readSettings(put("a.exr", "no picture")).empty());
    EXPECT_TRUE(readSettings(put("a.png", "\x89PNG cut")).empty());
    EXPECT_TRUE(readSettings(folder_).empty());
}

} // namespace dioptre
