#include "live/trial_message.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace dioptre
{

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TextureShape, target, stored, numberType, width, height, layers, levels,
                                   minification, magnification, wrapS, wrapT)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProgramTrial, fragment, vertex, blocks, uniforms, textures,
                                   marksEndedLoops, corners)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LogMessage, line, column, text, collapsed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialOutcome, messages, inVertexStage, compile_ms, firstDraw_ms,
                                   endedLoops, mean)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialMessage, number, drawLimit_s, trials)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialReply, number, outcomes, fault)

namespace
{

template <typename Message>
std::vector<std::uint8_t> framed(const Message& message)
{
    const auto body = nlohmann::json::to_cbor(nlohmann::json(message));
    const std::uint64_t length = body.size();
    std::vector<std::uint8_t> bytes(sizeof(length));
    std::memcpy(bytes.data(), &length, sizeof(length));
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

bool readAll(int descriptor, std::uint8_t* bytes, std::size_t count)
{
    while (count > 0) {
        const ssize_t got = ::read(descriptor, bytes, count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        bytes += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

// Shader texts and tables of numbers: a length beyond this is none of ours.
constexpr std::uint64_t mostBytes = std::uint64_t{1} << 30;

template <typename Message>
std::optional<Message> read(int descriptor)
{
    std::uint64_t length = 0;
    if (!readAll(descriptor, reinterpret_cast<std::uint8_t*>(&length), sizeof(length)) || length > mostBytes)
        return std::nullopt;
    std::vector<std::uint8_t> body(length);
    if (!readAll(descriptor, body.data(), body.size()))
        return std::nullopt;
    try {
        return nlohmann::json::from_cbor(body).template get<Message>();
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

} // namespace

std::vector<std::uint8_t> bytesOf(const TrialMessage& message)
{
    return framed(message);
}

std::vector<std::uint8_t> bytesOf(const TrialReply& reply)
{
    return framed(reply);
}

std::optional<TrialMessage> readTrialMessage(int descriptor)
{
    return read<TrialMessage>(descriptor);
}

std::optional<TrialReply> readTrialReply(int descriptor)
{
    return read<TrialReply>(descriptor);
}

bool writeAll(int descriptor, const std::vector<std::uint8_t>& bytes)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t wrote = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote <= 0)
            return false;
        done += static_cast<std::size_t>(wrote);
    }
    return true;
}

} // namespace dioptre
