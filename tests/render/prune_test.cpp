#include "render/prune.h"

#include <gtest/gtest.h>

using namespace dioptre;

TEST(Prune, WhatMainDoesNotReach_IsLeftOut)
{
    const auto source = linesOf(
        "uniform vec2 u_used; // px \nuniform vec2 u_unused;\n\n// Calls nothing.\nfloat unused()\n"
        "{\n    return 1.0;\n}\n\nfloat used(float x)\n{\n    return x;\n}\n\n"
        "layout(std140) uniform Used\n{\n    vec4 u_inside;\n};\nlayout(std140) uniform Unused\n{\n"
        "    vec4 u_outside;\n};\nout vec4 o;\nvoid main()\n{\n    o = used(u_used.x) * u_inside;\n}\n",
        "a.glsl");
    const auto text = flatten(prune(source));
    for (const char* gone : {"u_unused", "unused()", "Calls nothing", "u_outside", "Unused"})
        EXPECT_EQ(text.find(gone), std::string::npos) << gone << " in\n" << text;
    for (const char* kept : {"u_used", "used(float x)", "u_inside", "void main()"})
        EXPECT_NE(text.find(kept), std::string::npos) << kept << " not in\n" << text;
}
