// What travels through the vertex stage: each value in a place of its own, no more than there is room for,
// and nothing read that was not received.
#include "assembled.h"
#include "render/shared_values.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace dioptre;

namespace
{

// So many materials would be read from the table, which knows no shared ones.
const std::string bySelects = "[plan]\nlookup = \"selects\"\n";

// A row of balls, each of a material of its own.
std::string rowOfBalls(int count, const std::string& material)
{
    std::string toml = "[camera]\neye = [0, 0, 50]\n[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n";
    for (int i = 0; i < count; ++i) {
        const auto number = std::to_string(i);
        toml += "[material.m" + number + "]\n" + material + "[[sphere]]\ncentre = [" + std::to_string(3 * i) +
                ", 0, 0]\nradius = 1\nmaterial = \"m" + number + "\"\n";
    }
    return toml;
}

const std::string shiny = "colour = [1, 0, 0]\nmodel = \"phong\"\nspecular = [1, 1, 1]\nmirror = 0.5\n";
const std::string tinted = "transmit = 0.9\nior = 1.5\nabsorption = [1, 2, 3]\n";

// "shared_materials[3].mirror" and the like, where the text has them; members beyond the first are cut off.
std::set<std::string> sharedMaterialsIn(const std::string& text)
{
    std::set<std::string> found;
    const std::string name = "shared_materials[";
    for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
        found.insert(text.substr(at, text.find_first_of(" ;,:)\n", at) - at));
    return found;
}

// The fragment text in two: receiveShared(), and all that is not it.
std::pair<std::string, std::string> partedAtReceive(const std::string& text)
{
    const auto begin = text.find("void receiveShared()");
    const auto end = text.find("\n}\n", begin);
    return {text.substr(begin, end - begin), text.substr(0, begin) + text.substr(end)};
}

// Every read of shared_materials[i] is received; a whole material is given to shadows, which read its tint
// and its absorption.
void expectAllReceived(const Assembled& shader)
{
    const auto [receive, rest] = partedAtReceive(shader.fragment);
    const auto received = sharedMaterialsIn(receive);
    auto read = sharedMaterialsIn(rest);
    read.erase("shared_materials[MATERIAL_COUNT]");
    ASSERT_FALSE(read.empty());
    for (const auto& name : read)
        if (name.ends_with(']')) {
            EXPECT_TRUE(received.contains(name + ".shadow_tint.xyz")) << name;
            EXPECT_EQ(received.contains(name + ".shadow_absorption.xyz"),
                      shader.plan.defines.contains("HAS_ABSORPTION"))
                << name;
        } else
            EXPECT_TRUE(received.contains(name)) << name << " is read and not received";
}

} // namespace

TEST(SharedValues, EachTakesTheFirstVectorWithRoom)
{
    const std::vector<SharedValue> values = {{"u_a", 3}, {"u_b", 2}, {"u_c", 1},      {"u_d", 2},
                                             {"u_e", 4}, {"u_f", 3}, {"u_g", 1, true}};
    EXPECT_EQ(vectorsOf(values), 4);
    EXPECT_EQ(shareDeclaration(values), "flat out vec4 v_shared[4];\n");
    EXPECT_EQ(shareStatements(values), "    v_shared[0].xyz = u_a;\n"
                                       "    v_shared[1].xy = u_b;\n"
                                       "    v_shared[0].w = u_c;\n"
                                       "    v_shared[1].zw = u_d;\n"
                                       "    v_shared[2] = u_e;\n"
                                       "    v_shared[3].xyz = u_f;\n"
                                       "    v_shared[3].w = float(u_g);\n");
}

TEST(SharedValues, AreReceivedFromWhereTheyWereSent)
{
    const std::vector<SharedValue> values = {{"u_a", 3}, {"u_materials[2].mirror", 4}, {"u_budget", 1, true}};
    EXPECT_EQ(receiveText(values),
              "flat in vec4 v_shared[2];\n\n// Once for each pixel, before anything else.\n"
              "void receiveShared()\n{\n"
              "    u_a = v_shared[0].xyz;\n"
              "    shared_materials[2].mirror = v_shared[1];\n"
              "    u_budget = int(v_shared[0].w + 0.5);\n}\n");
    EXPECT_EQ(receiveText({}), "");
}

TEST(SharedValues, OfManyMaterials_FillTheirRoomAndOverlapNowhere)
{
    for (const auto& material : {shiny, tinted}) {
        const auto plan = assembled(bySelects + rowOfBalls(24, material)).plan;
        EXPECT_EQ(vectorsOf(plan.shared), mostSharedVectors);
        std::set<std::string> taken; // components: "v_shared[3].x"
        std::istringstream statements(shareStatements(plan.shared));
        std::size_t count = 0;
        for (std::string line; std::getline(statements, line); ++count) {
            const auto target = line.substr(4, line.find(" = ") - 4);
            const auto dot = target.find('.');
            const auto components = dot == std::string::npos ? "xyzw" : target.substr(dot + 1);
            EXPECT_EQ(components.size(), static_cast<std::size_t>(plan.shared[count].components)) << line;
            for (const char c : components)
                EXPECT_TRUE(taken.insert(target.substr(0, target.find('.')) + '.' + c).second) << line;
        }
        EXPECT_EQ(count, plan.shared.size());
    }
}

TEST(SharedValues, WhatHasNoRoom_IsReadFromItsBlock)
{
    for (const auto& material : {shiny, tinted}) {
        const auto shader = assembled(bySelects + rowOfBalls(24, material));
        expectAllReceived(shader);
        EXPECT_TRUE(shader.plan.has("shared materials"));
        EXPECT_NE(partedAtReceive(shader.fragment).second.find("u_materials[23]."), std::string::npos);
    }
}

TEST(SharedValues, WhereAllHaveRoom_NoPixelReadsTheBlock)
{
    for (const auto& material : {shiny, tinted}) {
        const auto shader = assembled(rowOfBalls(2, material));
        expectAllReceived(shader);
        EXPECT_EQ(shader.fragment.find("u_materials"), std::string::npos);
        EXPECT_EQ(shader.fragment.find("u_lights[0] ="), std::string::npos);
        EXPECT_NE(shader.vertex.find("u_materials[1]"), std::string::npos);
    }
}

TEST(SharedValues, OnADeviceThatCarriesFewer_StayWithinThat)
{
    // OpenGL 3.3 promises 60 components of varyings: 15 vec4.
    const Scene scene = underLightType(parseScene(bySelects + rowOfBalls(12, shiny), "text.toml"));
    const Plan plan = makePlan(scene, DataView::none, {15, Guard::unit});
    EXPECT_GT(vectorsOf(makePlan(scene).shared), 15);
    EXPECT_LE(vectorsOf(plan.shared), 15);
    EXPECT_TRUE(plan.has("shared view"));
}

TEST(SharedValues, AsUniforms_NothingTravels)
{
    const auto shader = assembled("[plan]\nvalues = \"uniforms\"\n" + rowOfBalls(2, shiny));
    EXPECT_TRUE(shader.plan.shared.empty());
    for (const char* gone : {"v_shared", "receiveShared", "shared_materials"}) {
        EXPECT_EQ(shader.fragment.find(gone), std::string::npos) << gone;
        EXPECT_EQ(shader.vertex.find(gone), std::string::npos) << gone;
    }
}
