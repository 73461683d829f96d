#include "base/file.h"
#include "base/picture_stack.h"
#include "picture_fixture.h"

#include <functional>

namespace dioptre
{
namespace
{

const Settings stackSettings = {{"dioptre.spp", "16"}, {"dioptre.set", "title=Sch\xC3\xB6n"}};

using Write = std::function<void(const std::filesystem::path&, const Picture&, const std::vector<ExrLayer>&)>;

const std::vector<Write> writes = {
    [](const auto& path, const auto& picture, const auto&) { writePng(path, picture, {}, stackSettings); },
    [](const auto& path, const auto& picture, const auto&) {
        writePng(path, picture, PngForm{true, 2.2, 16}, stackSettings);
    },
    [](const auto& path, const auto& picture, const auto&) { writeRadiance(path, picture, stackSettings); },
    [](const auto& path, const auto& picture, const auto& layers) {
        writeExr(path, picture, ExrDepth::half, stackSettings, layers);
    },
    [](const auto& path, const auto& picture, const auto&) {
        writeExr(path, picture, ExrDepth::full, stackSettings);
    },
};

// Rows [first, end) of a picture, counted from the bottom, and of a layer that numbers them.
void writeRows(const Write& write, const std::filesystem::path& path, const Picture& picture, int first,
               int end)
{
    const auto begin = picture.floats.begin();
    const auto row = static_cast<std::ptrdiff_t>(4 * picture.width);
    ExrLayer layer{"depth.Z", {}};
    for (int i = picture.width * first; i < picture.width * end; ++i)
        layer.numbers.push_back(0.37F * static_cast<float>(i));
    write(path, floatPicture(picture.width, end - first, {begin + row * first, begin + row * end}), {layer});
}

// Narrow ones too: their Radiance rows have no runs.
TEST_F(PictureFile, WriteStack_GivesTheBytesOfTheWhole)
{
    for (const auto& [width, height] : {std::pair{37, 200}, std::pair{5, 70}}) {
        const Picture picture = renderLikePicture(width, height);
        for (std::size_t kind = 0; kind < writes.size(); ++kind) {
            writeRows(writes[kind], folder_ / "whole", picture, 0, height);
            PictureStack stack{{}, width, height, stackSettings};
            int top = height;
            for (const int first : {height - 1, 35, 3, 0}) {
                stack.topDown.push_back(folder_ / ("from" + std::to_string(first)));
                writeRows(writes[kind], stack.topDown.back(), picture, first, top);
                top = first;
            }
            std::vector<double> told;
            writeStack(stack, folder_ / "joined", [&](double share) { told.push_back(share); });
            EXPECT_TRUE(readFile(folder_ / "joined") == readFile(folder_ / "whole"))
                << "kind " << kind << ", width " << width;
            EXPECT_EQ(told.back(), 1.0);
            EXPECT_TRUE(std::ranges::is_sorted(told));
        }
    }
}

TEST_F(PictureFile, WriteStack_OfACutFile_IsRefusedAndLeavesTheOldOne)
{
    const Picture picture = renderLikePicture(40, 40);
    for (const auto& write : writes) {
        writeRows(write, folder_ / "upper", picture, 20, 40);
        writeRows(write, folder_ / "lower", picture, 0, 20);
        const PictureStack stack{{folder_ / "upper", folder_ / "lower"}, 40, 40, stackSettings};
        put("joined", "old");
        const std::string bytes = readFile(folder_ / "lower");
        for (std::size_t size = 0; size < bytes.size();
             size = std::max(size + 1, std::min(size + bytes.size() / 40, bytes.size() - 1))) {
            put("lower", bytes.substr(0, size));
            try {
                readStoredHead(folder_ / "lower");
                writeStack(stack, folder_ / "joined", {});
                ADD_FAILURE() << "accepted with " << size << " of " << bytes.size() << " bytes";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ExitCode::badInput);
                EXPECT_TRUE(std::string(error.what()).starts_with((folder_ / "lower").string() + ": "))
                    << error.what();
            }
        }
        EXPECT_TRUE(readFile(folder_ / "joined") == "old");
        const auto files = std::filesystem::directory_iterator(folder_);
        EXPECT_EQ(std::distance(begin(files), end(files)), 3);
        put("lower", bytes);
        EXPECT_NO_THROW(writeStack(stack, folder_ / "joined", {}));
    }
}

TEST_F(PictureFile, StoredHead_TellsKindSizeAndForm)
{
    const std::vector<std::pair<StoredKind, std::string>> expected = {
        {StoredKind::png, "8 bits a channel"},
        {StoredKind::png, "16 bits a channel, gAMA 45455"},
        {StoredKind::radiance, ""},
        {StoredKind::exr, "channels B:16 G:16 R:16 depth.Z:32"},
        {StoredKind::exr, "channels B:32 G:32 R:32"},
    };
    for (std::size_t kind = 0; kind < writes.size(); ++kind) {
        writeRows(writes[kind], folder_ / "a", renderLikePicture(5, 7), 0, 7);
        const StoredHead head = readStoredHead(folder_ / "a");
        EXPECT_EQ(head.kind, expected[kind].first);
        EXPECT_EQ(head.form, expected[kind].second);
        EXPECT_EQ(head.width, 5);
        EXPECT_EQ(head.height, 7);
    }
}

} // namespace
} // namespace dioptre
