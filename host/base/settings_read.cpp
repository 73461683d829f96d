#include "base/exr_header.h"
#include "base/file.h"
#include "base/picture_stack.h"
#include "base/png_rows.h"
#include "base/radiance_head.h"

#include <ImfHeader.h>
#include <ImfStringAttribute.h>

#include <exception>

namespace dioptre
{
namespace
{

Settings settingsOfExr(const std::filesystem::path& path)
{
    const ExrInput input(path);
    const Imf::Header& header = input.file.header();
    Settings settings;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            settings[attribute.name()] = text->value();
    return settings;
}

Settings settingsOf(const std::filesystem::path& path)
{
    switch (storedKind(path)) {
    case StoredKind::png:
        return PngRows(path).settings();
    case StoredKind::radiance: {
        std::ifstream in = openFile(path);
        return readRadianceHead(path, in).settings;
    }
    case StoredKind::exr:
        return settingsOfExr(path);
    }
    return {};
}

} // namespace

Settings readSettings(const std::filesystem::path& path)
{
    try {
        return settingsOf(path);
    } catch (const std::exception&) {
        return {}; // missing, another kind of file, or broken
    }
}

} // namespace dioptre
