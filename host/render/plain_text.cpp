#include "render/plain_text.h"

#include "base/file.h"
#include "render/preprocess.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace dioptre
{
namespace
{

// What the text mentions and what it declares, comments left out; conditionals are not looked at.
struct Names {
    std::set<std::string> mentioned;
    std::set<std::string> uniforms;
    std::set<std::string> macros;
};

Names namesOf(const SourceText& source)
{
    Names names;
    bool inComment = false;
    for (const auto& line : source) {
        const auto words = identifiers(line.text, inComment);
        names.mentioned.insert(words.begin(), words.end());
        const auto declares = std::ranges::find(words, "uniform");
        if (declares != words.end())
            names.uniforms.insert(declares + 1, words.end());
        if (words.size() > 1 && words[0] == "define")
            names.macros.emplace(words[1]);
    }
    return names;
}

// The host writes the first line itself: a version of its own language, or of the one that browsers run, is
// left out.
SourceText withoutVersion(SourceText source)
{
    for (auto& line : source) {
        const auto start = line.text.find_first_not_of(" \t");
        if (start == std::string::npos || line.text.compare(start, 8, "#version") != 0)
            continue;
        const auto version = line.text.substr(start + 8);
        if (version.find("330") == std::string::npos && version.find("300 es") == std::string::npos)
            fail(ExitCode::badInput, {line.file, line.line, 1},
                 "'" + line.text + "' is not a version that dioptre runs",
                 "write #version 330 core or 300 es, or no such line");
        line.text.clear();
    }
    return source;
}

// Built-ins of GLSL ES 3.00 and of older GLSL that 3.30 does not have under these names.
std::string builtIns(const Names& names)
{
    std::string text;
    for (const char* name : {"packHalf2x16", "unpackHalf2x16", "packSnorm2x16", "unpackSnorm2x16",
                             "packUnorm2x16", "unpackUnorm2x16"})
        if (text.empty() && names.mentioned.contains(name))
            text = "#extension GL_ARB_shading_language_packing : require\n";
    for (const auto& [old, now] : {std::pair{"texture2D", "texture"},
                                   {"textureCube", "texture"},
                                   {"texture2DLod", "textureLod"},
                                   {"texture2DLodEXT", "textureLod"}})
        if (names.mentioned.contains(old))
            text += fmt::format("#define {} {}\n", old, now);
    return text;
}

// What Shadertoy declares before an image's shader, less what the shader declares itself. Names that nothing
// mentions stay out.
std::string shadertoyHeader(const Names& names, const std::array<ChannelKind, 4>& channels)
{
    std::string text = "#define HW_PERFORMANCE 1\n#define iGlobalTime iTime\n"
                       "#define gl_FragColor colourOfTheShader\n"
                       "vec4 colourOfTheShader;\n";
    if (names.mentioned.contains("main") && !names.macros.contains("main"))
        text += "#define main mainOfTheShader\n";
    const auto declare = [&](const std::string& type, const std::string& name, const std::string& count) {
        if (!names.uniforms.contains(name))
            text += "uniform " + type + " " + name + count + ";\n";
    };
    for (const auto& [type, name, count] : {std::array{"vec3", "iResolution", ""},
                                            {"float", "iTime", ""},
                                            {"float", "iTimeDelta", ""},
                                            {"float", "iFrameRate", ""},
                                            {"int", "iFrame", ""},
                                            {"vec4", "iDate", ""},
                                            {"vec4", "iMouse", ""},
                                            {"float", "iSampleRate", ""},
                                            {"float", "iChannelTime", "[4]"},
                                            {"vec3", "iChannelResolution", "[4]"}})
        declare(type, name, count);
    for (std::size_t i = 0; i < channels.size(); ++i)
        declare(channels[i] == ChannelKind::cube ? "samplerCube" : "sampler2D", fmt::format("iChannel{}", i),
                "");
    return text;
}

// Names of one letter are often macros of the shader: none stands here.
constexpr const char* shadertoyMain = "#undef main\n"
                                      "out vec4 dioptre_pixel;\n"
                                      "void main()\n"
                                      "{\n"
                                      "    vec4 dioptre_colour = vec4(0.0, 0.0, 0.0, 1.0);\n"
                                      "    mainImage(dioptre_colour, gl_FragCoord.xy);\n"
                                      "    dioptre_pixel = dioptre_colour;\n"
                                      "    dioptre_pixel[3] = 1.0;\n"
                                      "}\n";

void append(SourceText& text, const SourceText& more)
{
    text.insert(text.end(), more.begin(), more.end());
}

} // namespace

PlainText assemblePlain(const std::filesystem::path& shader, const std::filesystem::path& glslFolder,
                        const std::array<ChannelKind, 4>& channels)
{
    PreprocessInput input;
    input.folders = {shader.has_parent_path() ? shader.parent_path() : ".", glslFolder};
    const SourceText body = preprocess(withoutVersion(readSource(shader)), input);
    const Names names = namesOf(body);
    PlainText plain;
    plain.mainImage = names.mentioned.contains("mainImage");
    if (!plain.mainImage && !names.mentioned.contains("main"))
        fail(ExitCode::badInput, {shader.string()}, "neither main() nor mainImage() is in it",
             "write void mainImage(out vec4 fragColor, in vec2 fragCoord), as on Shadertoy, or void main()");
    append(plain.text, linesOf("#version 330 core\n" + builtIns(names), "generated"));
    if (plain.mainImage)
        append(plain.text, linesOf(shadertoyHeader(names, channels), "generated"));
    append(plain.text, body);
    if (plain.mainImage)
        append(plain.text, linesOf(shadertoyMain, "generated"));
    return plain;
}

} // namespace dioptre
