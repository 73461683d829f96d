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

TEST_F(SettingsInAFile, OfARadiancePicture_AreReadBackWithoutLineBreaks)
{
    Settings written = settings;
    written["dioptre.legend"] = "a = 1\nb";
    written["empty"] = "";
    writeRadiance(folder_ / "a.hdr", floatPicture(1, 1, {0, 0, 0, 1}), written);
    written["dioptre.legend"] = "a = 1 b";
    EXPECT_EQ(readSettings(folder_ / "a.hdr"), written);
}

TEST_F(SettingsInAFile, OfAForeignRadiancePicture_AreItsLines)
{
    const std::string head = "#?RGBE\n# by hand\nVIEW= -vp 0 0 0\noconv\nFORMAT=32-bit_rle_rgbe\n";
    EXPECT_EQ(readSettings(put("a.hdr", head + "\n-Y 1 +X 1\n....")), (Settings{{"VIEW", " -vp 0 0 0"}}));
    EXPECT_TRUE(readSettings(put("b.hdr", head)).empty());
    EXPECT_TRUE(readSettings(put("c.hdr", "#?RADIANCE\na=b\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n")).empty());
}

TEST_F(SettingsInAFile, OfWhatIsMissingOrBroken_AreNone)
{
    EXPECT_TRUE(readSettings(folder_ / "nowhere.png").empty());
    EXPECT_TRUE(readSettings(put("a.exr", "no picture")).empty());
    EXPECT_TRUE(readSettings(put("a.png", "\x89PNG cut")).empty());
    EXPECT_TRUE(readSettings(put("empty", "")).empty());
    EXPECT_TRUE(readSettings(folder_).empty());
}

} // namespace dioptre
