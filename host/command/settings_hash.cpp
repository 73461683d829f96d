#include "command/settings_hash.h"

#include "base/text.h"
#include "command/still_writer.h"

#include <fmt/format.h>

namespace dioptre
{

std::string settingsHash(const RenderOptions& options, const ContextInfo& context, unsigned long long sources)
{
    RenderOptions whole = options;
    whole.tile.clear();
    whole.settingsHash.clear();
    std::string all =
        fmt::format("{:016x}\nhalf {}\nview {}\nbits {}\nexposure {}\ncurve {}\ngamma {}\nmouse {}\n",
                    sources, options.half, options.view, options.bits == 16 ? 16 : 8,
                    options.exposure ? fmt::format("{}", *options.exposure) : "the scene's", options.curve,
                    options.gamma, options.mouse);
    for (const auto& [key, value] : settingsOf(whole, context))
        all += key + " " + value + "\n";
    return fmt::format("{:016x}", fingerprint(all));
}

} // namespace dioptre
