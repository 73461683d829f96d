#include "render/plain_text.h"

#include "base/file.h"
#include "render/endless_loop.h"
#include "render/preprocess.h"
#include "render/shader_tokens.h"

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

    bool any(std::initializer_list<const char*> words) const
    {
        return std::ranges::any_of(words, [this](const char* word) { return mentioned.contains(word); });
    }
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
    bool inComment = false;
    for (auto& line : source) {
        const auto start = line.text.find_first_not_of(" \t");
        const bool directive = !inComment && start != std::string::npos && line.text[start] == '#';
        const auto words = identifiers(line.text, inComment);
        if (!directive || words.empty() || words.front() != "version")
            continue;
        const std::string_view version(words.front().end(), line.text.data() + line.text.size());
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

// The main() of the shader's own makes room for the host's, and the pixels of a tile have their places in the
// whole picture.
std::string frameHeader(const Names& names, const ShaderTokens& tokens, const std::filesystem::path& shader,
                        bool ownMain, bool inTiles)
{
    std::string text;
    if (ownMain && names.mentioned.contains("main") && !names.macros.contains("main"))
        text += "#define main mainOfTheShader\n";
    if (!inTiles)
        return text;
    const auto declared = [](const ShaderToken& type, const ShaderToken& name) {
        return type.text == "vec4" && name.text == "gl_FragCoord";
    };
    if (std::ranges::adjacent_find(tokens.all, declared) != tokens.all.end())
        fail(ExitCode::badInput, {shader.string()},
             "it declares gl_FragCoord anew, and in tiles that cannot be followed",
             "leave the declaration out, or draw a smaller --size");
    return text +
           fmt::format("uniform vec2 {0};\n#define gl_FragCoord (gl_FragCoord + vec4({0}, 0.0, 0.0))\n",
                       tileOriginUniform);
}

// Software drivers end the loops of a pixel after so many iterations, and all that follow after one: this
// loop runs twice only where none was ended.
std::string loopCheck()
{
    return fmt::format("uniform int {0};\n"
                       "bool dioptre_loopsWereEnded()\n{{\n"
                       "    int turns = 0;\n"
                       "    while (turns < {0})\n        ++turns;\n"
                       "    return turns < 2;\n}}\n",
                       loopCheckUniform);
}

// Where the shader's own main() writes: "fragColor" of 4 components. No name where that cannot be told.
struct Output {
    std::string name;
    int components = 0;
    bool isFirst = false; // of several, by its layout
};

// The components of a type of floats, 0 for any other.
int componentsOf(std::string_view type)
{
    const std::array<std::string_view, 4> types = {"float", "vec2", "vec3", "vec4"};
    const auto found = std::ranges::find(types, type);
    return found == types.end() ? 0 : static_cast<int>(found - types.begin()) + 1;
}

// The declaration behind the "out" at `at`. No name for one of no floats, or of several numbers of them.
Output declarationAt(const std::vector<ShaderToken>& all, std::size_t at)
{
    const auto word = [&](std::size_t i) { return i < all.size() ? all[i].text : std::string_view(); };
    std::size_t next = at + 1;
    while (word(next) == "highp" || word(next) == "mediump" || word(next) == "lowp")
        ++next;
    if (componentsOf(word(next)) == 0 || word(next + 2) != ";")
        return {};
    // layout ( location = 0 ) out
    const bool first = at >= 3 && word(at - 1) == ")" && word(at - 2) == "0" && word(at - 3) == "=";
    return {std::string(word(next + 1)), componentsOf(word(next)), first};
}

// The only output, or the one at location 0. None where conditionals decide.
Output outputOf(const ShaderTokens& tokens, const Names& names)
{
    std::vector<Output> outputs;
    for (std::size_t i = 0; i < tokens.all.size(); ++i) {
        const auto& token = tokens.all[i];
        if (token.text == "{" || (token.text == "(" && i > 0 && tokens.all[i - 1].text != "layout")) {
            i = afterBracket(tokens.all, i) - 1; // a body, or a function's parameters
        } else if (token.text == "out") {
            outputs.push_back(declarationAt(tokens.all, i));
            if (token.depth > 0)
                outputs.back() = {};
        }
    }
    if (outputs.size() == 1)
        return outputs.front();
    for (const auto& output : outputs)
        if (output.isFirst)
            return output;
    return outputs.empty() && names.mentioned.contains("gl_FragColor") ? Output{"gl_FragColor", 4, true}
                                                                       : Output{};
}

// Names of one letter are often macros of the shader: none stands here.
std::string frameMain(const Output& output, bool mainImage, bool checksLoops)
{
    std::string text = "#undef main\n";
    if (checksLoops)
        text += loopCheck();
    if (mainImage)
        text += "out vec4 dioptre_pixel;\n";
    text += "void main()\n{\n";
    text += mainImage ? "    vec4 dioptre_colour = vec4(0.0, 0.0, 0.0, 1.0);\n"
                        "    mainImage(dioptre_colour, gl_FragCoord.xy);\n"
                        "    dioptre_pixel = dioptre_colour;\n"
                        "    dioptre_pixel[3] = 1.0;\n"
                      : "    mainOfTheShader();\n";
    if (checksLoops)
        text += fmt::format(
            "    if (dioptre_loopsWereEnded())\n        {}{} = uintBitsToFloat({}u);\n", output.name,
            output.components > 1 ? fmt::format("[{}]", output.components - 1) : "", loopsWereEnded);
    return text + "}\n";
}

void append(SourceText& text, const SourceText& more)
{
    text.insert(text.end(), more.begin(), more.end());
}

} // namespace

Search includeSearch(const std::filesystem::path& shader, const SearchPlaces& places)
{
    std::vector<std::filesystem::path> data;
    if (!places.glslFolder.empty())
        data.push_back(places.glslFolder);
    return searchFrom(shader, places, data, "shader");
}

PlainText assemblePlain(const std::filesystem::path& shader, const SearchPlaces& places,
                        const PlainForm& form)
{
    PreprocessInput input;
    input.search = includeSearch(shader, places);
    const SourceText body = preprocess(withoutVersion(readSource(shader)), input);
    const ShaderTokens tokens = tokensOf(body);
    refuseEndlessLoops(tokens);
    const Names names = namesOf(body);
    PlainText plain;
    plain.mainImage = names.mentioned.contains("mainImage");
    if (!plain.mainImage && !names.mentioned.contains("main"))
        fail(ExitCode::badInput, {shader.string()}, "neither main() nor mainImage() is in it",
             "write void mainImage(out vec4 fragColor, in vec2 fragCoord), as on Shadertoy, or void main()");
    const Output output = plain.mainImage ? Output{"dioptre_pixel", 4, true} : outputOf(tokens, names);
    plain.discards = names.mentioned.contains("discard");
    plain.checksLoops = form.loopsMayBeEnded && !output.name.empty() && !names.macros.contains("main") &&
                        names.any({"for", "while", "do"});
    const bool ownMain = plain.mainImage || plain.checksLoops;
    std::string header = "#version 330 core\n" + builtIns(names);
    if (plain.mainImage)
        header += shadertoyHeader(names, form.channels);
    append(plain.text,
           linesOf(header + frameHeader(names, tokens, shader, ownMain, form.inTiles), "generated"));
    append(plain.text, body);
    if (ownMain)
        append(plain.text, linesOf(frameMain(output, plain.mainImage, plain.checksLoops), "generated"));
    return plain;
}

} // namespace dioptre
