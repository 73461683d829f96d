#include "base/lettering.h"

#include "base/error.h"
#include "canvas_fixture.h"

namespace dioptre
{
namespace
{

constexpr Colour8 white = {255, 255, 255};
constexpr Pixel blackPixel = {0, 0, 0, 255};

// Pixels of a row that are not black.
int inkInRow(const Picture& picture, int y)
{
    int count = 0;
    for (int x = 0; x < picture.width; ++x)
        count += pixelAt(picture, x, y) != blackPixel ? 1 : 0;
    return count;
}

TEST(Lettering, Width_GrowsWithTheTextAndItsSize)
{
    const Lettering lettering(16);
    EXPECT_EQ(lettering.width(""), 0);
    std::string text;
    for (const std::string letter : {"P", "h", " ", "o", "é", ":", "…", "\n", "i"}) {
        const int before = lettering.width(text);
        text += letter;
        EXPECT_GT(lettering.width(text), before) << text;
    }
    EXPECT_GT(lettering.width("mmm"), lettering.width("iii"));
    EXPECT_NEAR(Lettering(32).width("RMSE 0.0123"), 2 * lettering.width("RMSE 0.0123"), 2);
}

TEST(Lettering, Draw_KeepsToTheBoxAndFillsIt)
{
    for (const int size : {8, 11, 17, 28, 90})
        for (const std::string text : {"jågpq|fä()_Q", "j", "f", "W", "12.3 ms (0.45)", "ß…"}) {
            const Lettering lettering(size);
            const int x = 40, baseline = 50, width = lettering.width(text);
            Picture picture = blankCanvas(width + 2 * x, lettering.lineHeight() + 2 * baseline, {});
            lettering.draw(picture, text, x, baseline, white);
            const auto ink = inkOf(picture, blackPixel);
            ASSERT_TRUE(ink) << text;
            EXPECT_GE(ink->x, x) << text << size;
            EXPECT_LE(ink->x + ink->width, x + width) << text << size;
            EXPECT_GE(ink->y, baseline - lettering.descent()) << text << size;
            EXPECT_LE(ink->y + ink->height, baseline + lettering.ascent()) << text << size;
            EXPECT_GE(ink->width, width - 2 - size / 4)
                << text << size; // no more than the letters' own margins
        }
}

TEST(Lettering, Draw_StandsUpright)
{
    const Lettering lettering(24);
    Picture picture = blankCanvas(40, 40, {});
    lettering.draw(picture, "L", 5, 10, white);
    const auto ink = inkOf(picture, blackPixel);
    ASSERT_TRUE(ink);
    EXPECT_EQ(ink->y, 10); // its foot is the baseline's first row
    EXPECT_GT(inkInRow(picture, ink->y), 2 * inkInRow(picture, ink->y + ink->height - 1));
    EXPECT_NEAR(ink->height, 0.73 * 24, 1.5);
}

TEST(Lettering, Draw_OverAnEdge_IsTheCutOfAWholeOne)
{
    const Lettering lettering(20);
    const std::string text = "jWäg:32";
    Picture whole = blankCanvas(300, 200, {30, 60, 90});
    lettering.draw(whole, text, 100, 100, white);
    const int width = lettering.width(text);
    for (const PixelRectangle& seen : {PixelRectangle{110, 90, 20, 30},
                                       {90, 105, 200, 4},
                                       {100 + width / 2, 80, 60, 60},
                                       {50, 80, 50 + width / 2, 22},
                                       {0, 0, 90, 200},
                                       {0, 150, 300, 50}}) {
        Picture part = blankCanvas(seen.width, seen.height, {30, 60, 90});
        lettering.draw(part, text, 100 - seen.x, 100 - seen.y, white);
        EXPECT_EQ(part.bytes, cutOut(whole, seen).bytes) << seen.x << "," << seen.y;
    }
}

TEST(Lettering, Draw_MixesTheColourAtEdgesAndLeavesAlpha)
{
    Picture picture = blankCanvas(80, 40, {});
    for (std::size_t i = 3; i < picture.bytes.size(); i += 4)
        picture.bytes[i] = 77;
    Lettering(24).draw(picture, "SO", 5, 10, {200, 0, 0});
    int full = 0, mixed = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Pixel pixel = pixelAt(picture, x, y);
            EXPECT_LE(pixel[0], 200);
            EXPECT_EQ(pixel[1] + pixel[2], 0);
            EXPECT_EQ(pixel[3], 77);
            full += pixel[0] == 200 ? 1 : 0;
            mixed += pixel[0] > 0 && pixel[0] < 200 ? 1 : 0;
        }
    EXPECT_GT(full, 20);
    EXPECT_GT(mixed, 20);
}

TEST(Lettering, ControlCharacters_AreSpaces_BrokenBytesAreMarked)
{
    const Lettering lettering(16);
    EXPECT_EQ(lettering.width("a\nb\tc"), lettering.width("a b c"));
    EXPECT_EQ(lettering.width("a\xFFz"), lettering.width("a\uFFFDz"));
}

TEST(Lettering, Shortened_EndsInAnEllipsisAsLateAsItCan)
{
    const Lettering lettering(16);
    const std::string text = "gouraud:32";
    const int whole = lettering.width(text);
    EXPECT_EQ(lettering.shortened(text, whole), text);
    const std::string cut = lettering.shortened(text, whole - 1);
    EXPECT_EQ(cut, "gouraud:…");
    for (int width = whole; width >= 0; --width) {
        const std::string shortened = lettering.shortened(text, width);
        EXPECT_LE(lettering.width(shortened), width);
        if (!shortened.empty() && shortened != text) {
            const std::size_t kept = shortened.size() - std::string("…").size();
            EXPECT_EQ(shortened, text.substr(0, kept) + "…");
            EXPECT_GT(lettering.width(text.substr(0, kept + 1) + "…"), width) << "one more has place";
        }
    }
    EXPECT_EQ(lettering.shortened(text, lettering.width("g…")), "g…");
    EXPECT_EQ(lettering.shortened(text, lettering.width("g…") - 1), "");
    EXPECT_EQ(lettering.shortened(text, -5), "");
}

TEST(Lettering, Shortened_CutsBetweenLetters)
{
    const Lettering lettering(16);
    EXPECT_EQ(lettering.shortened("éééééééé", lettering.width("ééé…")), "ééé…");
}

TEST(Lettering, LegibleSize_FollowsThePictureWithinBounds)
{
    EXPECT_EQ(legibleSize(0), 11);
    EXPECT_EQ(legibleSize(64), 11);
    EXPECT_EQ(legibleSize(440), 20);
    EXPECT_EQ(legibleSize(4000), 28);
}

void expectFontRefused(const std::filesystem::path& font, ExitCode code)
{
    try {
        const Lettering lettering(16, font);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        const std::string message = error.what();
        EXPECT_NE(message.find(font.string()), std::string::npos) << message;
        EXPECT_NE(message.find("fonts-dejavu-core"), std::string::npos) << message;
    }
}

TEST(Lettering, MissingFont_IsToldWithItsPackage)
{
    expectFontRefused("/nowhere/DejaVuSans.ttf", ExitCode::inputMissing);
}

TEST(Lettering, FileThatIsNoFont_IsRefused)
{
    expectFontRefused(DIOPTRE_SOURCE_DIR "/README.md", ExitCode::badInput);
}

} // namespace
} // namespace dioptre
