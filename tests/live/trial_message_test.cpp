// Messages between the window and its helper come over whole, or are known to be none.
#include "live/trial_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <thread>
#include <unistd.h>

namespace dioptre::test
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

// Two ends that are closed when it goes.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe()
    {
        EXPECT_EQ(::pipe(ends.data()), 0);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe()
    {
        close(0);
        close(1);
    }
    void close(std::size_t end)
    {
        if (ends[end] >= 0)
            ::close(std::exchange(ends[end], -1));
    }
};

// What the reader finds in a pipe that ends behind these bytes.
template <typename Read>
auto readFrom(const Bytes& bytes, Read read)
{
    Pipe pipe;
    std::thread writer([&] {
        EXPECT_TRUE(writeAll(pipe.ends[1], bytes));
        pipe.close(1);
    });
    auto message = read(pipe.ends[0]);
    writer.join();
    return message;
}

ProgramTrial trial()
{
    ProgramTrial trial;
    trial.fragment = "void main()\n{\n}\n// \xe4 is no UTF-8, and a \t and a \\ are themselves";
    trial.vertex = "vertex";
    trial.blocks["Lights"] = {0.1F, -0.0F, 3e38F, std::numeric_limits<float>::infinity()};
    trial.uniforms["iTime"] = {1.0 / 3.0};
    trial.uniforms["u_many"] = {1.0, 2.0, 3.0};
    TextureShape shape;
    shape.target = GL_TEXTURE_2D_ARRAY;
    shape.stored = GL_RGBA32F;
    shape.numberType = GL_FLOAT;
    shape.width = 7;
    shape.height = 5;
    shape.layers = 3;
    shape.levels = 2;
    shape.minification = GL_LINEAR_MIPMAP_LINEAR;
    shape.magnification = GL_NEAREST;
    shape.wrapS = GL_CLAMP_TO_EDGE;
    shape.wrapT = GL_MIRRORED_REPEAT;
    trial.textures.emplace_back("iChannel0", shape);
    trial.marksEndedLoops = true;
    return trial;
}

TrialReply reply()
{
    TrialOutcome outcome;
    outcome.messages = {{3, 14, "error: `x' undeclared", true}, {0, 0, "warning", false}};
    outcome.inVertexStage = true;
    outcome.compile_ms = 12.5;
    outcome.firstDraw_ms = 0.25;
    outcome.endedLoops = 17;
    outcome.mean = {0.5, -1.0, std::numeric_limits<double>::infinity(), 2.0};
    return {9, {{}, outcome}, "a fault"};
}

} // namespace

TEST(TrialMessage, Message_ComesOverWhole)
{
    const auto read = readFrom(bytesOf(TrialMessage{41, 2.5, {trial(), {}}}), readTrialMessage);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->number, 41);
    EXPECT_EQ(read->drawLimit_s, 2.5);
    ASSERT_EQ(read->trials.size(), 2U);
    const ProgramTrial& one = read->trials.front();
    EXPECT_EQ(one.fragment, trial().fragment);
    EXPECT_EQ(one.vertex, trial().vertex);
    EXPECT_EQ(one.blocks, trial().blocks);
    EXPECT_TRUE(std::signbit(one.blocks.at("Lights")[1]));
    EXPECT_EQ(one.uniforms, trial().uniforms);
    EXPECT_TRUE(one.marksEndedLoops);
    ASSERT_EQ(one.textures.size(), 1U);
    EXPECT_EQ(one.textures.front().first, "iChannel0");
    const TextureShape shape = one.textures.front().second, sent = trial().textures.front().second;
    EXPECT_EQ(std::memcmp(&shape, &sent, sizeof(shape)), 0);
    EXPECT_TRUE(read->trials.back().fragment.empty());
}

TEST(TrialMessage, Reply_ComesOverWhole)
{
    const auto read = readFrom(bytesOf(reply()), readTrialReply);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->number, 9);
    EXPECT_EQ(read->fault, "a fault");
    ASSERT_EQ(read->outcomes.size(), 2U);
    EXPECT_TRUE(read->outcomes.front().messages.empty());
    const TrialOutcome& outcome = read->outcomes.back();
    EXPECT_TRUE(outcome.inVertexStage);
    EXPECT_EQ(outcome.compile_ms, 12.5);
    EXPECT_EQ(outcome.firstDraw_ms, 0.25);
    EXPECT_EQ(outcome.endedLoops, 17U);
    EXPECT_EQ(outcome.mean, reply().outcomes.back().mean);
}

// How a column is to be counted comes with it: else a caret stands in the wrong place.
TEST(TrialMessage, DriversMessages_ComeOverWithAllThatPlacesThem)
{
    const auto read = readFrom(bytesOf(reply()), readTrialReply);
    ASSERT_TRUE(read);
    const auto& messages = read->outcomes.back().messages;
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0].line, 3);
    EXPECT_EQ(messages[0].column, 14);
    EXPECT_EQ(messages[0].text, "error: `x' undeclared");
    EXPECT_TRUE(messages[0].collapsed);
    EXPECT_FALSE(messages[1].collapsed);
}

TEST(TrialMessage, LargerThanThePipe_ComesOverInPieces)
{
    ProgramTrial large;
    large.fragment = std::string(3'000'000, 'x');
    const auto read = readFrom(bytesOf(TrialMessage{1, 5.0, {large}}), readTrialMessage);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->trials.front().fragment, large.fragment);
}

TEST(TrialMessage, SeveralInARow_AreReadInOrder_ThenTheEnd)
{
    Pipe pipe;
    for (const long number : {1L, 2L})
        ASSERT_TRUE(writeAll(pipe.ends[1], bytesOf(TrialMessage{number, 5.0, {}})));
    pipe.close(1);
    for (const long number : {1L, 2L}) {
        const auto read = readTrialMessage(pipe.ends[0]);
        ASSERT_TRUE(read);
        EXPECT_EQ(read->number, number);
    }
    EXPECT_FALSE(readTrialMessage(pipe.ends[0]));
}

TEST(TrialMessage, CutOffAnywhere_IsNone)
{
    const Bytes whole = bytesOf(TrialMessage{41, 2.5, {}});
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(
            readFrom({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}, readTrialMessage))
            << length;
}

TEST(TrialMessage, LengthBeyondAllReason_IsNone_AndNoMemoryIsTaken)
{
    for (const std::uint64_t length : {~std::uint64_t{0}, std::uint64_t{1} << 40}) {
        Bytes bytes(sizeof(length));
        std::memcpy(bytes.data(), &length, sizeof(length));
        EXPECT_FALSE(readFrom(bytes, readTrialMessage));
    }
}

TEST(TrialMessage, BytesOfAnotherKind_AreNone)
{
    const auto framed = [](const Bytes& body) {
        const std::uint64_t length = body.size();
        Bytes bytes(sizeof(length));
        std::memcpy(bytes.data(), &length, sizeof(length));
        bytes.insert(bytes.end(), body.begin(), body.end());
        return bytes;
    };
    EXPECT_FALSE(readFrom(framed({0xff, 0xff, 0xff}), readTrialMessage)); // no CBOR
    EXPECT_FALSE(readFrom(framed({}), readTrialMessage));
    EXPECT_FALSE(readFrom(framed({0x07}), readTrialMessage)); // a number
    EXPECT_FALSE(readFrom(bytesOf(reply()), readTrialMessage));
}

TEST(TrialMessage, NobodyReads_TheWriterIsTold)
{
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    Pipe pipe;
    pipe.close(0);
    EXPECT_FALSE(writeAll(pipe.ends[1], bytesOf(TrialMessage{})));
    std::signal(SIGPIPE, before);
}

} // namespace dioptre::test
