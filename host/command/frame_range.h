// Which frames --frames asks for, when each is, and what its file is called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre
{

struct FrameRange {
    int first = 0;
    int last = 0; // is drawn only where the steps lead to it
    int step = 1;
};

// "A:B" or "A:B:S". Throws usage for anything else, a range that runs backwards, numbers below 0, steps
// below 1.
FrameRange readFrameRange(const std::string& text);

std::vector<int> numbersOf(const FrameRange& range);

// From the number alone, never summed, so that a frame is at the same time in every range. Seconds.
double timeOf(int frame, double start_s, double fps);

// The files of numbered pictures. "turn.png" gives turn.0007.png; a run of # in the name stands for the
// number. It has 4 digits, or as many as there are #, and as many as the largest number needs.
class FrameNames
{
public:
    // Throws usage for two runs of #, for # in a folder's name and for printf's %04d.
    FrameNames(const std::string& output, int largest);

    std::string of(int frame) const;

    // The same with # for digits.
    std::string pattern() const;

private:
    std::string before_;
    std::string after_;
    std::size_t digits_;
};

} // namespace dioptre
