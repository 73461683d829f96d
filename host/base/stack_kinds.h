// One pair of functions for each kind of file that picture_stack.h knows.
#pragma once

#include "base/picture_stack.h"

namespace dioptre
{

StoredHead readPngHead(const std::filesystem::path& path);
StoredHead readExrHead(const std::filesystem::path& path);
StoredHead readHdrHead(const std::filesystem::path& path);

// `rowsDone` is told how many of all rows are done.
using RowsDone = std::function<void(int)>;
void stackPngs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone);
void stackExrs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone);
void stackHdrs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone);

constexpr int rowsBetweenReports = 64;

} // namespace dioptre
