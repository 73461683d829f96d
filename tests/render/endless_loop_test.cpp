#include "render/endless_loop.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

// Where the loop is that is refused, "line:column"; "" where none is.
std::string refusedAt(const std::string& text)
{
    try {
        const SourceText source = linesOf(text, "a.frag"); // the tokens look into it
        refuseEndlessLoops(tokensOf(source));
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        const std::string what = error.what();
        EXPECT_NE(what.find("this loop never ends"), std::string::npos) << what;
        return what.substr(7, what.find(": ") - 7);
    }
}

TEST(EndlessLoop, ThatNothingLeaves_IsRefusedAtItsPlace)
{
    EXPECT_EQ(refusedAt("void f()\n{\n    while (true) {}\n}\n"), "3:5");
    EXPECT_EQ(refusedAt("void f() { for (;;); }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { for (int i = 0;; ++i) { x += 1.0; } return; }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { for (int i = 0; true; ++i) x += 1.0; }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { do { x += 1.0; } while (true); return; }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { do x += 1.0; while (true); return; }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { do { do { x += 1.0; } while (true); return; } while (true); }"), "1:17");
    EXPECT_EQ(refusedAt("void f() { while/* break */(true) // return\n { x *= 2.0; } }"), "1:12");
    EXPECT_EQ(refusedAt("void f() { while (a) { for (;;) { x *= 2.0; } break; } }"), "1:24");
}

TEST(EndlessLoop, ThatSomethingMayLeave_IsLeftAlone)
{
    for (const char* text :
         {"void f() { while (true) { if (x > 1.0) break; x *= 2.0; } }",
          "void f() { while (true) { if (x > 1.0) return; x *= 2.0; } }",
          "void f() { for (;;) if (x > 1.0) { discard; } else x *= 2.0; }",
          "void f() { do { if (x > 1.0) break; } while (true); }",
          "void f() { do if (x > 1.0) break; while (true); }",
          "void f() { do { x *= 2.0; } while (x < 9.0); }",
          "#define OUT if (x > 1.0) break\nvoid f() { for (;;) { x *= 2.0; OUT; } }",
          "#define EVER for (;;) \\\n    x *= 2.0;\nvoid f() {}",
          "// for (;;);\n/* while (true)\n {} */ void f() {}",
          "void f() { for (int i = 0; i < 9; ++i) {} while (x < 1.0) {} }",
          "void f() { bool formal; float whiles; formal = true; }", "for", "while (", "do", "do {"})
        EXPECT_EQ(refusedAt(text), "") << text;
}

} // namespace
} // namespace dioptre
