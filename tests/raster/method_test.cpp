// The words of --method.
#include "raster/method.h"

#include "base/error.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

std::string refusalOf(const std::string& text)
{
    try {
        methodNamed(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "";
}

} // namespace

TEST(Method, IsReadAsItIsNamed)
{
    for (const char* name : {"trace", "flat:8", "gouraud:32", "phong:512"})
        EXPECT_EQ(nameOf(methodNamed(name)), name);
    EXPECT_EQ(methodNamed("flat").facets, usualFacets);
    EXPECT_FALSE(isRasterised(methodNamed("trace")));
    EXPECT_TRUE(isRasterised(methodNamed("phong:8")));
}

TEST(Method, WithoutSenseIsRefusedWithTheMend)
{
    for (const char* text : {"phong:7", "phong:513", "phong:", "phong:x", "phong:16x", "phong:-16",
                             "phong:1e2", "gouraud: 16"}) {
        const std::string refusal = refusalOf(text);
        EXPECT_NE(refusal.find("8 to 512"), std::string::npos) << text << ": " << refusal;
        EXPECT_NE(refusal.find(":64"), std::string::npos) << text << ": " << refusal;
    }
    EXPECT_NE(refusalOf("phnog:16").find("trace, flat:N, gouraud:N, phong:N"), std::string::npos);
    EXPECT_NE(refusalOf("").find("no such method"), std::string::npos);
    EXPECT_NE(refusalOf("trace:16").find("without facets"), std::string::npos);
}
