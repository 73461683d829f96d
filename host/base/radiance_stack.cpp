#include "base/checked_file.h"
#include "base/error.h"
#include "base/picture_codecs.h"
#include "base/radiance_head.h"
#include "base/stack_kinds.h"

namespace dioptre
{
namespace
{

// The rows of a Radiance picture as they are coded, checked but not decoded.
class CodedRows
{
public:
    explicit CodedRows(const std::filesystem::path& path)
        : path_(path), in_(openFile(path)), head_(readRadianceHead(path, in_))
    {
    }

    int height() const
    {
        return head_.height;
    }

    // Until the next call.
    const std::string& next()
    {
        row_.clear();
        if (head_.width < 8 || head_.width > 32767) { // without runs
            take(4 * static_cast<std::size_t>(head_.width));
            return row_;
        }
        const std::string start = {2, 2, static_cast<char>(head_.width / 256),
                                   static_cast<char>(head_.width % 256)};
        take(4);
        if (row_ != start)
            failBroken(path_, "a row does not begin with its width");
        for (int plane = 0; plane < 4; ++plane)
            takePlane();
        return row_;
    }

    void end()
    {
        if (in_.peek() != std::ifstream::traits_type::eof())
            failBroken(path_, "something stands below its last row");
    }

private:
    // Appends so many bytes of the file to the row.
    void take(std::size_t count)
    {
        const std::size_t size = row_.size();
        row_.resize(size + count);
        in_.read(row_.data() + size, static_cast<std::streamsize>(count));
        if (!in_)
            failBroken(path_, "its pixels end too early");
    }

    // Runs: n > 128 repeats the next byte n - 128 times, n <= 128 is followed by n bytes.
    void takePlane()
    {
        for (std::size_t done = 0; done < static_cast<std::size_t>(head_.width);) {
            take(1);
            const std::size_t code = static_cast<std::uint8_t>(row_.back());
            const std::size_t count = code > 128 ? code - 128 : code;
            done += count;
            if (count == 0 || done > static_cast<std::size_t>(head_.width))
                failBroken(path_, "a run is longer than its row");
            take(code > 128 ? 1 : count);
        }
    }

    const std::filesystem::path& path_;
    std::ifstream in_;
    RadianceHead head_;
    std::string row_;
};

} // namespace

StoredHead readHdrHead(const std::filesystem::path& path)
{
    std::ifstream in = openFile(path);
    const RadianceHead head = readRadianceHead(path, in);
    return {StoredKind::radiance, head.width, head.height, ""};
}

// Each row is coded by itself.
void stackHdrs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone)
{
    CheckedFile file(output);
    const std::string text = radianceText({stack.width, stack.height, stack.settings});
    file.write(text.data(), text.size());
    int done = 0;
    for (const auto& path : stack.topDown) {
        CodedRows rows(path);
        for (int i = 0; i < rows.height(); ++i) {
            const std::string& row = rows.next();
            file.write(row.data(), row.size());
            if (++done % rowsBetweenReports != 0 && done != stack.height)
                continue;
            file.check();
            rowsDone(done);
        }
        rows.end();
    }
    file.finish();
}

} // namespace dioptre
