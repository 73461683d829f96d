#include "base/contact_sheet.h"

#include "base/lettering.h"
#include "canvas_fixture.h"

namespace dioptre
{
namespace
{

const std::string longTitle =
    "a method of a title that is far longer than any picture here is wide, and goes on";

// The pixels of a sheet to the right of its column `x`.
Picture rightOf(const Picture& sheet, int x)
{
    return cutOut(sheet, {x, 0, sheet.width - x, sheet.height});
}

TEST(ContactSheet, Pictures_KeepTheirPixels_InOneRow)
{
    const Picture a = noise(120, 50, 1), b = noise(120, 50, 2), c = noise(100, 40, 3);
    const Picture sheet = contactSheet("heading", {{"a", {"RMSE 0.1"}, a}, {"b", {}, b}, {"c", {}, c}});
    EXPECT_EQ(sheet.format, PixelFormat::srgb8);
    const auto atA = placeOf(a, sheet), atB = placeOf(b, sheet), atC = placeOf(c, sheet);
    ASSERT_TRUE(atA && atB && atC);
    EXPECT_GT(atB->x, atA->x + 120);
    EXPECT_GT(atC->x, atB->x + 120);
    EXPECT_EQ(atC->x - atB->x, atB->x - atA->x);
    EXPECT_EQ(atA->y, atB->y);
    EXPECT_EQ(atC->y + 40, atB->y + 50); // upper edges are level
    EXPECT_GT(sheet.width, atC->x + 100);
}

TEST(ContactSheet, Differences_StandUnderTheirPictures)
{
    const Picture a = noise(120, 50, 1), b = noise(120, 50, 2), difference = noise(120, 50, 3);
    const Picture sheet = contactSheet("heading", {{"a", {"reference"}, a}, {"b", {"RMSE"}, b, difference}});
    const auto atB = placeOf(b, sheet), atDifference = placeOf(difference, sheet);
    ASSERT_TRUE(placeOf(a, sheet) && atB && atDifference);
    EXPECT_EQ(atDifference->x, atB->x);
    EXPECT_LT(atDifference->y + 50,
              atB->y - 2 * Lettering(11).lineHeight()); // a line and the caption between
    const Picture without = contactSheet("heading", {{"a", {"reference"}, a}, {"b", {"RMSE"}, b}});
    EXPECT_LT(without.height, sheet.height - 50);
}

TEST(ContactSheet, ColumnWithoutDifference_SaysSoInItsCell)
{
    const Picture a = noise(120, 50, 1), b = noise(120, 50, 2);
    const std::vector<SheetColumn> columns = {{"a", {}, a}, {"b", {}, b, b}};
    Picture named = contactSheet("", columns, {.withoutOne = "reference"});
    const Picture unnamed = contactSheet("", columns, {.withoutOne = ""});
    ASSERT_EQ(named.width, unnamed.width);
    ASSERT_EQ(named.height, unnamed.height);
    const auto atA = placeOf(a, named);
    ASSERT_TRUE(atA);
    for (std::size_t i = 0; i < named.bytes.size(); ++i)
        named.bytes[i] = named.bytes[i] == unnamed.bytes[i] ? 0 : 255;
    const auto changed = inkOf(named, {0, 0, 0, 0});
    ASSERT_TRUE(changed);
    EXPECT_GE(changed->x, atA->x);
    EXPECT_LE(changed->x + changed->width, atA->x + 120);
    EXPECT_LT(changed->y + changed->height, atA->y);
}

TEST(ContactSheet, LongTitleAndLine_StayInTheirColumn)
{
    const Picture a = noise(300, 20, 1), b = noise(300, 20, 2);
    const Picture cut = contactSheet("", {{longTitle, {longTitle}, a}, {"b", {"b"}, b}});
    const Picture plain = contactSheet("", {{"a", {"a"}, a}, {"b", {"b"}, b}});
    const auto atA = placeOf(a, cut);
    ASSERT_TRUE(atA);
    ASSERT_EQ(cut.width, plain.width);
    EXPECT_NE(cut.bytes, plain.bytes);
    EXPECT_EQ(rightOf(cut, atA->x + 300).bytes, rightOf(plain, atA->x + 300).bytes);
}

TEST(ContactSheet, SmallPictures_GetColumnsAsWideAsTheirTexts)
{
    const std::string line = "12.3 ms (0.45), of a frame";
    const Picture a = noise(64, 36, 1), b = noise(64, 36, 2);
    const int needed = Lettering(11).width(line);
    ASSERT_GT(needed, 100);
    const Picture sheet = contactSheet("", {{"a", {line}, a}, {"b", {}, b}});
    EXPECT_GT(placeOf(b, sheet)->x - placeOf(a, sheet)->x, needed);
    const Picture bounded = contactSheet("", {{longTitle + longTitle, {}, a}, {"b", {}, b}});
    EXPECT_LE(placeOf(b, bounded)->x - placeOf(a, bounded)->x, 23 * 11);
}

TEST(ContactSheet, ColumnsBeyondTheWidestSheet_GoOnBelow)
{
    std::vector<SheetColumn> columns;
    for (unsigned i = 0; i < 4; ++i)
        columns.push_back({"a", {"b"}, noise(1200, 6, i), noise(1200, 6, 10 + i)});
    const Picture sheet = contactSheet("heading", columns); // three would have place
    EXPECT_LE(sheet.width, widestSheet);
    std::vector<PixelRectangle> places;
    for (const SheetColumn& column : columns)
        for (const Picture& picture : {column.picture, *column.difference}) {
            const auto place = placeOf(picture, sheet);
            ASSERT_TRUE(place);
            places.push_back(*place);
        }
    EXPECT_EQ(places[2].y, places[0].y); // the second beside the first
    EXPECT_GE(places[2].x, places[0].x + 1200);
    EXPECT_EQ(places[4].x, places[0].x); // the third below the first and its difference
    EXPECT_LT(places[4].y + 6, places[1].y);
    EXPECT_EQ(places[6].x, places[2].x);
    EXPECT_EQ(places[7].y, places[5].y);
}

TEST(ContactSheet, ColumnWiderThanTheWidestSheet_StandsAlone)
{
    const Picture a = noise(4100, 2, 1), b = noise(4100, 2, 2);
    const Picture sheet = contactSheet("", {{"a", {}, a}, {"b", {}, b}});
    ASSERT_TRUE(placeOf(a, sheet) && placeOf(b, sheet));
    EXPECT_EQ(placeOf(a, sheet)->x, placeOf(b, sheet)->x);
}

TEST(ContactSheet, HeadingAndCaption_WidenANarrowSheet)
{
    const Picture a = noise(64, 36, 1);
    const std::vector<SheetColumn> columns = {{"a", {}, a, a}};
    const int narrow = contactSheet("", columns, {.caption = ""}).width;
    EXPECT_GT(contactSheet("still_life, 400x400, 16 samples", columns, {.caption = ""}).width, narrow + 50);
    EXPECT_GT(contactSheet("", columns, {.caption = "difference, white = 0.25"}).width, narrow + 50);
    std::string text = longTitle;
    for (int i = 0; i < 5; ++i)
        text += text;
    EXPECT_LE(contactSheet(text, columns, {.caption = text}).width, 60 * 11);
}

TEST(ContactSheet, Scale_IsDrawnFromItsFirstColourToItsLast)
{
    const Picture a = blankCanvas(200, 20, {});
    const Picture sheet =
        contactSheet("", {{"a", {}, a, a}}, {.scale = {{255, 0, 1}, {1, 255, 0}, {0, 1, 255}}});
    const auto columnOf = [&](const Pixel& colour) {
        for (int x = 0; x < sheet.width; ++x)
            for (int y = 0; y < sheet.height; ++y)
                if (pixelAt(sheet, x, y) == colour)
                    return x;
        return -1;
    };
    const int first = columnOf({255, 0, 1, 255}), middle = columnOf({1, 255, 0, 255}),
              last = columnOf({0, 1, 255, 255});
    EXPECT_GT(first, 0);
    EXPECT_LT(first, middle);
    EXPECT_LT(middle, last);
}

TEST(ContactSheet, WithoutColumns_IsTheHeading)
{
    const Picture sheet = contactSheet("heading", {});
    EXPECT_TRUE(inkOf(sheet, pixelAt(sheet, 0, 0)));
    EXPECT_LT(sheet.height, 60);
}

} // namespace
} // namespace dioptre
