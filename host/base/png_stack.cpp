#include "base/png_rows.h"
#include "base/stack_kinds.h"

#include <fmt/format.h>

namespace dioptre
{

StoredHead readPngHead(const std::filesystem::path& path)
{
    const PngHead head = PngRows(path).head();
    std::string form = fmt::format("{} bits a channel", head.bits);
    if (head.gamma_100000ths)
        form += fmt::format(", gAMA {}", *head.gamma_100000ths);
    return {StoredKind::png, head.width, head.height, form};
}

// Decoded and encoded again: a PNG's rows are one stream of zlib's.
void stackPngs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone)
{
    PngHead head = PngRows(stack.topDown.front()).head();
    head.height = stack.height;
    PngEncoder encoder(output, head, stack.settings);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(head.width) * static_cast<std::size_t>(head.bits) /
                                  8 * 3);
    int done = 0;
    for (const auto& path : stack.topDown) {
        PngRows rows(path);
        const int height = rows.head().height;
        rows.begin();
        for (int i = 0; i < height; ++i) {
            rows.next(row.data(), row.size());
            encoder.add(row.data(), row.size());
            if (++done % rowsBetweenReports == 0 || done == stack.height)
                rowsDone(done);
        }
        rows.end();
    }
    encoder.finish();
}

} // namespace dioptre
