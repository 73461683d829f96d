#include "base/file.h"
#include "base/picture.h"

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <spng.h>

#include <exception>
#include <memory>

namespace dioptre
{
namespace
{

Settings settingsOfPng(const std::string& bytes)
{
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), &spng_ctx_free);
    std::uint32_t count = 0;
    if (spng_set_png_buffer(context.get(), bytes.data(), bytes.size()) != 0 ||
        spng_get_text(context.get(), nullptr, &count) != 0)
        return {};
    std::vector<spng_text> chunks(count);
    if (spng_get_text(context.get(), chunks.data(), &count) != 0)
        return {};
    Settings settings;
    for (const auto& chunk : chunks)
        settings[chunk.keyword] = std::string(chunk.text, chunk.length);
    return settings;
}

Settings settingsOfExr(const std::string& bytes)
{
    Imf::StdISStream stream;
    stream.str(bytes);
    const Imf::InputFile file(stream);
    Settings settings;
    for (auto attribute = file.header().begin(); attribute != file.header().end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            settings[attribute.name()] = text->value();
    return settings;
}

} // namespace

Settings readSettings(const std::filesystem::path& path)
{
    try {
        const std::string bytes = readFile(path);
        return bytes.starts_with("\x89PNG") ? settingsOfPng(bytes) : settingsOfExr(bytes);
    } catch (const std::exception&) {
        return {}; // missing, another kind of file, or broken
    }
}

} // namespace dioptre
