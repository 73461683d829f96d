// Every scene of tests/scenes/ shows what its comment derives: with literal geometry, as a loop over a table,
// in double precision, and under the overrides that it names.
#include "kernel/reference.h"
#include "support/answers.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class Answers : public testing::TestWithParam<std::filesystem::path>
{
};

std::string testName(const testing::TestParamInfo<std::filesystem::path>& info)
{
    std::string name = info.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char letter) { return !std::isalnum(letter); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Answers, testing::ValuesIn(answerScenes()), testName);

// Writes the pictures that the scene asks for; removes them at the end.
class PictureFiles
{
public:
    explicit PictureFiles(const Answer& answer)
        : folder_(std::filesystem::temp_directory_path() /
                  fmt::format("dioptre-{}-{}", getpid(), answer.scene.stem().string()))
    {
        std::filesystem::create_directories(folder_);
        for (const auto& picture : answer.pictures) {
            const auto file = folder_ / (picture.key + ".png");
            writePng(file, pictureOf(picture), {}, {});
            overrides_.push_back(picture.key + "=" + file.string());
        }
    }
    ~PictureFiles()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    PictureFiles(const PictureFiles&) = delete;
    PictureFiles& operator=(const PictureFiles&) = delete;

    Request request(const Answer& answer, const std::vector<std::string>& more, double time_s) const
    {
        Request request{answer.width, answer.height, answer.samples, overrides_, "auto", time_s};
        request.overrides.insert(request.overrides.end(), more.begin(), more.end());
        return request;
    }

private:
    std::filesystem::path folder_;
    std::vector<std::string> overrides_;
};

// The first few failures of a picture, under the settings that drew it.
void expectHolds(const Answer& answer, const Picture& picture, double time_s, const std::string& how)
{
    const std::string settings = fmt::format("{}, at {} s", how, time_s);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < picture.floats.size(); ++i)
        bad += std::isfinite(picture.floats[i]) ? 0 : 1;
    EXPECT_EQ(bad, 0U) << answer.scene.string() << ": values that are NaN or infinite, " << settings;
    constexpr std::size_t shown = 5;
    const auto failures = failuresOf(answer, picture, time_s);
    for (std::size_t i = 0; i < std::min(shown, failures.size()); ++i)
        ADD_FAILURE() << failures[i] << ", " << settings;
    if (failures.size() > shown)
        ADD_FAILURE() << failures.size() - shown << " pixels more, " << settings;
}

std::string joined(const std::vector<std::string>& overrides)
{
    std::string text;
    for (const auto& change : overrides)
        text += (text.empty() ? "" : " ") + change;
    return text;
}

// The reference speaks only for the sources that it was compiled from.
bool referenceSpeaks()
{
    static const bool same = shaderFingerprint(glslFolder()) == compiledShaderFingerprint();
    return same;
}

// The answer with no tolerance below that.
Answer within(Answer answer, double tolerance)
{
    for (auto& expectation : answer.expectations)
        expectation.tolerance = std::max(expectation.tolerance, tolerance);
    return answer;
}

} // namespace

// By one renderer over all moments, so that what is baked once shows.
TEST_P(Answers, HoldForOtherMethods)
{
    const Answer answer = readAnswer(GetParam());
    const PictureFiles files(answer);
    const auto moments = momentsOf(answer);
    for (const auto& method : answer.methods) {
        Request request = files.request(answer, {}, 0.0);
        request.method = method.name;
        const auto pictures = rasteriseMoments(GetParam(), request, moments);
        for (std::size_t i = 0; i < moments.size(); ++i)
            expectHolds(within(answer, method.tolerance), pictures[i].picture, moments[i],
                        "--method " + method.name);
    }
}

TEST_P(Answers, Hold)
{
    const Answer answer = readAnswer(GetParam());
    const PictureFiles files(answer);
    std::vector<std::vector<std::string>> settings{{"trace.form=literal"}, {"trace.form=loop"}};
    settings.insert(settings.end(), answer.also.begin(), answer.also.end());
    for (const double time_s : momentsOf(answer)) {
        for (const auto& overrides : settings)
            expectHolds(answer, renderScene(GetParam(), files.request(answer, overrides, time_s)).picture,
                        time_s, joined(overrides));
        if (referenceSpeaks())
            expectHolds(answer, renderDouble(GetParam(), files.request(answer, {}, time_s)), time_s,
                        "double precision");
    }
}
