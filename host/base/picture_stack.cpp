#include "base/picture_stack.h"

#include "base/error.h"
#include "base/file.h"
#include "base/stack_kinds.h"

namespace dioptre
{

std::optional<StoredKind> storedKindNamed(const std::filesystem::path& name)
{
    const auto extension = name.extension();
    if (extension == ".png")
        return StoredKind::png;
    if (extension == ".hdr")
        return StoredKind::radiance;
    if (extension == ".exr")
        return StoredKind::exr;
    return std::nullopt;
}

StoredKind storedKind(const std::filesystem::path& path)
{
    std::ifstream in = openFile(path);
    std::string start(8, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start == "\x89PNG\r\n\x1a\n")
        return StoredKind::png;
    if (start.starts_with("#?RADI") || start.starts_with("#?RGBE"))
        return StoredKind::radiance;
    if (start.starts_with("\x76\x2f\x31\x01"))
        return StoredKind::exr;
    fail(ExitCode::badInput, {path.string()}, "is no PNG, Radiance HDR or EXR picture",
         "name a picture that dioptre wrote");
}

StoredHead readStoredHead(const std::filesystem::path& path)
{
    switch (storedKind(path)) {
    case StoredKind::png:
        return readPngHead(path);
    case StoredKind::radiance:
        return readHdrHead(path);
    case StoredKind::exr:
        return readExrHead(path);
    }
    return {};
}

void writeStack(const PictureStack& stack, const std::filesystem::path& output,
                const std::function<void(double)>& progress)
{
    const RowsDone rowsDone = [&](int rows) {
        if (progress)
            progress(static_cast<double>(rows) / stack.height);
    };
    switch (storedKind(stack.topDown.front())) {
    case StoredKind::png:
        return stackPngs(stack, output, rowsDone);
    case StoredKind::radiance:
        return stackHdrs(stack, output, rowsDone);
    case StoredKind::exr:
        return stackExrs(stack, output, rowsDone);
    }
}

} // namespace dioptre
