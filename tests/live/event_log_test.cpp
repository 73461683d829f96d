// Events for scripts: one line of JSON each, at once, whatever they hold.
#include "live/event_log.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>
#include <unistd.h>

namespace dioptre::test
{
namespace
{

// What goes to standard output meanwhile, without a flush of our own.
std::string printedBy(const std::function<void()>& work)
{
    std::fflush(stdout);
    std::FILE* const file = std::tmpfile();
    const int before = ::dup(STDOUT_FILENO);
    ::dup2(::fileno(file), STDOUT_FILENO);
    work();
    ::dup2(before, STDOUT_FILENO);
    ::close(before);
    std::rewind(file);
    std::string printed;
    for (int byte = std::fgetc(file); byte != EOF; byte = std::fgetc(file))
        printed += static_cast<char>(byte);
    std::fclose(file);
    return printed;
}

} // namespace

TEST(EventLog, On_OneLineAnEvent_WithItsNameFirst)
{
    const std::string printed = printedBy([] {
        const EventLog log(true);
        log.say("opened", {{"input", "a.toml"}});
        log.say("done");
    });
    EXPECT_EQ(printed, "{\"event\":\"opened\",\"input\":\"a.toml\"}\n{\"event\":\"done\"}\n");
}

TEST(EventLog, Off_PrintsNothing)
{
    EXPECT_EQ(printedBy([] { EventLog(false).say("done", {{"samples", 1}}); }), "");
    EXPECT_FALSE(EventLog(false).isOn());
}

// A driver's message may hold line breaks, and a file's name any bytes.
TEST(EventLog, AnyText_StaysALineOfGoodJson)
{
    const std::string printed = printedBy([] {
        EventLog(true).say("error", {{"text", "a\nb\"c\\ \xe4 \x01"}});
    });
    EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 1);
    EXPECT_EQ(printed.back(), '\n');
    const auto line = nlohmann::json::parse(printed);
    EXPECT_EQ(line.at("text"), "a\nb\"c\\ \xef\xbf\xbd \x01"); // U+FFFD for what is no UTF-8
}

TEST(EventLog, NumbersThatJsonHasNot_AreNull)
{
    const std::string printed = printedBy([] { EventLog(true).say("shown", {{"load_ms", std::nan("")}}); });
    EXPECT_TRUE(nlohmann::json::parse(printed).at("load_ms").is_null());
}

} // namespace dioptre::test
