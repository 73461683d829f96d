// Program trials and their outcomes as bytes, for the pipe between the window and its helper.
#pragma once

#include "render/trial.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

struct TrialMessage {
    long number = 0;
    double drawLimit_s = 5.0;
    std::vector<ProgramTrial> trials;
};

struct TrialReply {
    long number = 0;
    std::vector<TrialOutcome> outcomes; // of the trials in order, up to the first that failed
    std::string fault;                  // "" or what went wrong apart from a program's text
};

// The bytes of a message with its length before them.
std::vector<std::uint8_t> bytesOf(const TrialMessage& message);
std::vector<std::uint8_t> bytesOf(const TrialReply& reply);

// Waits for a whole message; nothing at the end of the stream or where it holds none.
std::optional<TrialMessage> readTrialMessage(int descriptor);
std::optional<TrialReply> readTrialReply(int descriptor);

// Writes all bytes; false where nobody reads them.
bool writeAll(int descriptor, const std::vector<std::uint8_t>& bytes);

} // namespace dioptre
