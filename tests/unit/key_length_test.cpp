#include "scene/key_length.h"

#include "scene/document.h"

#include <gtest/gtest.h>

using namespace dioptre;

TEST(LongKey, OfMoreParts_IsFoundAtItsDot)
{
    const auto place =
        longKeyIn("title = \"a.b.c.d\" # a.b.c.d\nx = [1.5, 2.5, 3.5, 4.5]\n[a . 'b'.c.d]\n", 3);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->line, 3);
    EXPECT_EQ(place->column, 11);
    EXPECT_FALSE(longKeyIn("[a . 'b'.c.d]", 4));
}

TEST(LongKey, WithinStringsAndComments_IsNone)
{
    EXPECT_FALSE(
        longKeyIn("a = \"x\\\".y.z\"\nb = 'x.y.z\\'\nc = \"\"\"\n\"x.y.z\\\"\"\"\n.y.z\"\"\"\n# x.y.z", 2));
    EXPECT_FALSE(longKeyIn("a.b = '''\n.c.d.e'''\n", 2));
    EXPECT_FALSE(longKeyIn("", 2));
    EXPECT_FALSE(longKeyIn("a = \"never closed .b.c", 2));
    EXPECT_FALSE(longKeyIn("a = \"ends in \\", 2));
}

TEST(LongKey, InAScene_IsRefusedWithItsPlace)
{
    std::string text = "[sky]\na";
    for (int i = 0; i < 100000; ++i)
        text += ".a";
    try {
        parseDocument(text + " = 1\n", "b.toml");
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("b.toml:2:32: ")) << error.what();
    }
}
