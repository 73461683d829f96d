// Bytes as a plain shader and the files that it includes: assembled, and its comments read and written.
#include "fuzz.h"

#include "render/annotation.h"
#include "render/input_files.h"
#include "render/plain_text.h"

#include <array>

using namespace dioptre;

namespace
{

constexpr std::string_view cut = "//--\n";
constexpr std::array<std::string_view, 4> names{"main.frag", "a.glsl", "b.glsl", "c.glsl"};

// Cuts the bytes into the main file and up to three includes; gives the first.
std::string writeFiles(const std::filesystem::path& folder, std::string_view bytes)
{
    std::string first;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t end = i + 1 < names.size() ? bytes.find(cut) : std::string_view::npos;
        const std::string_view part = bytes.substr(0, end);
        if (i == 0)
            first = part;
        fuzz::write(folder / names[i], part);
        bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + cut.size());
    }
    return first;
}

// Values in the middle of their ranges, written and read back.
void editAnnotations(const std::string& file)
{
    fuzz::demand(withDefaults(file, {}) == file);
    std::map<std::string, std::vector<double>> values;
    for (const auto& annotation : annotationsOf(linesOf(file, "main.frag")))
        values[annotation.name] = std::vector<double>(annotation.defaults.size(), annotation.low);
    annotationsOf(linesOf(withDefaults(file, values), "main.frag"));
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::filesystem::path folder = fuzz::emptyFolder();
    const std::string first = writeFiles(folder, fuzz::textOf(data, size));
    const std::filesystem::path shader = folder / names[0];
    const SearchPlaces places{{}, fuzz::glslOfSources};
    for (const bool onSoftware : {false, true})
        fuzz::succeeds([&] {
            const PlainForm form{.inTiles = onSoftware, .loopsMayBeEnded = onSoftware};
            annotationsOf(assemblePlain(shader, places, form).text);
        });
    fuzz::demand(!filesOfShader(shader, places).empty()); // it never throws
    fuzz::succeeds([&] { editAnnotations(first); });
    return 0;
}
