#include "support/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

namespace dioptre::test
{
namespace
{

// Words of one line, read in order.
class Words
{
public:
    Words(const std::string& text, std::string where) : words_(text), where_(std::move(where)) {}

    template <typename Value>
    Value next()
    {
        Value value{};
        if (!(words_ >> value))
            refuse("a word is missing or no number");
        return value;
    }

    // The next character or word that must stand there.
    void skip(const std::string& wanted)
    {
        for (const char letter : wanted)
            if (next<char>() != letter)
                refuse("'" + wanted + "' is missing");
    }

    bool more()
    {
        return static_cast<bool>(words_ >> std::ws) && words_.peek() != EOF;
    }

    [[noreturn]] void refuse(const std::string& what) const
    {
        throw std::invalid_argument(where_ + ": " + what);
    }

private:
    std::istringstream words_;
    std::string where_;
};

BlockPicture readPictureLine(Words& words)
{
    BlockPicture picture;
    picture.key = words.next<std::string>();
    words.skip("=blocksof");
    picture.block = words.next<int>();
    words.skip(":");
    picture.rows.push_back(words.next<std::string>());
    while (words.more()) {
        words.skip("/");
        picture.rows.push_back(words.next<std::string>());
    }
    for (const auto& row : picture.rows)
        if (row.size() != picture.rows.front().size() || row.find_first_not_of("krgbcmywh") != row.npos)
            words.refuse("rows are of one length, of the letters krgbcmywh");
    return picture;
}

void readPixel(Words& words, int& x, int& y)
{
    x = words.next<int>();
    words.skip(",");
    y = words.next<int>();
}

void readSymmetry(Words& words, Expectation& expectation)
{
    const auto axis = words.next<std::string>();
    if (axis == "left-right")
        expectation.kind = Expectation::Kind::leftRight;
    else if (axis == "top-bottom")
        expectation.kind = Expectation::Kind::topBottom;
    else if (axis == "diagonal")
        expectation.kind = Expectation::Kind::diagonal;
    else
        words.refuse("symmetric left-right, top-bottom or diagonal");
}

Expectation readExpectation(Words& words, const Answer& answer, int line)
{
    Expectation expectation;
    expectation.line = line;
    expectation.time_s = answer.time_s;
    expectation.x1 = answer.width - 1;
    expectation.y1 = answer.height - 1;
    const auto what = words.next<std::string>();
    if (what == "symmetric") {
        readSymmetry(words, expectation);
    } else {
        if (what == "png")
            expectation.kind = Expectation::Kind::png;
        if (what == "every") {
            words.skip("pixel");
        } else if (what == "pixels") {
            readPixel(words, expectation.x0, expectation.y0);
            words.skip("to");
            readPixel(words, expectation.x1, expectation.y1);
        } else if (what == "pixel" || what == "png") {
            readPixel(words, expectation.x0, expectation.y0);
            expectation.x1 = expectation.x0;
            expectation.y1 = expectation.y0;
        } else {
            words.refuse("expect: pixel, pixels, every pixel, png or symmetric");
        }
        words.skip("=");
        for (double& channel : expectation.value)
            channel = words.next<double>();
    }
    if (expectation.kind != Expectation::Kind::png) {
        words.skip("within");
        expectation.tolerance = words.next<double>();
    }
    if (expectation.x1 >= answer.width || expectation.y1 >= answer.height)
        words.refuse("the pixel is not in the picture: give the size first");
    return expectation;
}

void readLine(const std::string& key, Words& words, int line, Answer& answer)
{
    if (key == "size") {
        answer.width = words.next<int>();
        words.skip("x");
        answer.height = words.next<int>();
    } else if (key == "samples") {
        answer.samples = words.next<int>();
    } else if (key == "time") {
        answer.time_s = words.next<double>();
    } else if (key == "picture") {
        answer.pictures.push_back(readPictureLine(words));
    } else if (key == "also") {
        answer.also.emplace_back();
        while (words.more())
            answer.also.back().push_back(words.next<std::string>());
    } else if (key == "method") {
        answer.methods.push_back({words.next<std::string>(), 0.0});
        words.skip("within");
        answer.methods.back().tolerance = words.next<double>();
    } else if (key == "expect") {
        answer.expectations.push_back(readExpectation(words, answer, line));
    }
}

// One channel of a picture of four.
double channelOf(const Picture& picture, int x, int y, int channel)
{
    const auto i = static_cast<std::size_t>(4 * (y * picture.width + x) + channel);
    return picture.format == PixelFormat::float32 ? static_cast<double>(picture.floats.at(i))
                                                  : static_cast<double>(picture.bytes.at(i));
}

// The pixel that must look alike.
void partnerOf(Expectation::Kind kind, const Picture& picture, int& x, int& y)
{
    if (kind == Expectation::Kind::leftRight)
        x = picture.width - 1 - x;
    if (kind == Expectation::Kind::topBottom)
        y = picture.height - 1 - y;
    if (kind == Expectation::Kind::diagonal)
        std::swap(x, y);
}

// "" where the pixel is as expected.
std::string failureAt(const Expectation& expectation, const Picture& picture, int x, int y)
{
    const bool absolute =
        expectation.kind == Expectation::Kind::colour || expectation.kind == Expectation::Kind::png;
    double found[3], wanted[3];
    bool holds = true;
    for (int channel = 0; channel < 3; ++channel) {
        int column = x, row = y;
        partnerOf(expectation.kind, picture, column, row);
        found[channel] = channelOf(picture, x, y, channel);
        wanted[channel] = absolute ? expectation.value[channel] : channelOf(picture, column, row, channel);
        // Written so that a NaN does not hold.
        holds = holds && std::abs(found[channel] - wanted[channel]) <= expectation.tolerance;
    }
    if (holds)
        return "";
    return fmt::format("pixel {},{}: expected {:.7g} {:.7g} {:.7g} within {:g}, found {:.7g} {:.7g} {:.7g}",
                       x, y, wanted[0], wanted[1], wanted[2], expectation.tolerance, found[0], found[1],
                       found[2]);
}

// The picture as its PNG tells it.
Picture throughPng(const Picture& picture)
{
    const auto file = std::filesystem::temp_directory_path() / fmt::format("dioptre-answer-{}.png", getpid());
    writePng(file, picture, {}, {});
    const Picture bytes = readPicture(file);
    std::filesystem::remove(file);
    return bytes;
}

} // namespace

std::vector<std::filesystem::path> answerScenes()
{
    std::vector<std::filesystem::path> scenes;
    const auto folder = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "tests" / "scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

Answer readAnswer(const std::filesystem::path& scene)
{
    Answer answer;
    answer.scene = scene;
    std::ifstream file(scene);
    std::string text;
    for (int line = 1; std::getline(file, text); ++line) {
        const auto colon = text.find(':');
        if (!text.starts_with("# ") || colon == text.npos)
            continue;
        Words words(text.substr(colon + 1), fmt::format("{}:{}", scene.string(), line));
        readLine(text.substr(2, colon - 2), words, line, answer);
    }
    if (answer.expectations.empty())
        throw std::invalid_argument(scene.string() + ": no line \"# expect:\"");
    return answer;
}

Picture pictureOf(const BlockPicture& blocks)
{
    const auto block = static_cast<std::size_t>(blocks.block);
    Picture picture;
    picture.width = static_cast<int>(blocks.rows.front().size() * block);
    picture.height = static_cast<int>(blocks.rows.size() * block);
    picture.format = PixelFormat::srgb8;
    for (std::size_t y = 0; y < blocks.rows.size() * block; ++y) {
        // Rows of a picture run from the bottom up, those of the comment from the top down.
        const auto& letters = blocks.rows[blocks.rows.size() - 1 - y / block];
        for (std::size_t x = 0; x < letters.size() * block; ++x) {
            const char letter = letters[x / block];
            for (const std::string among : {"rmywh", "gcywh", "bcmwh"})
                picture.bytes.push_back(among.find(letter) == among.npos ? 0 : letter == 'h' ? 188 : 255);
            picture.bytes.push_back(255);
        }
    }
    return picture;
}

std::vector<double> momentsOf(const Answer& answer)
{
    std::set<double> moments;
    for (const auto& expectation : answer.expectations)
        moments.insert(expectation.time_s);
    return {moments.begin(), moments.end()};
}

std::vector<std::string> failuresOf(const Answer& answer, const Picture& picture, double time_s)
{
    std::vector<std::string> failures;
    Picture bytes;
    for (const auto& expectation : answer.expectations) {
        if (expectation.time_s != time_s)
            continue;
        if (expectation.kind == Expectation::Kind::png && bytes.bytes.empty())
            bytes = throughPng(picture);
        const Picture& seen = expectation.kind == Expectation::Kind::png ? bytes : picture;
        for (int y = expectation.y0; y <= expectation.y1; ++y)
            for (int x = expectation.x0; x <= expectation.x1; ++x)
                if (const auto failure = failureAt(expectation, seen, x, y); !failure.empty())
                    failures.push_back(
                        fmt::format("{}:{}: {}", answer.scene.string(), expectation.line, failure));
    }
    return failures;
}

} // namespace dioptre::test
