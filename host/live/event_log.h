// What happens in a window as lines of JSON, for scripts and editors.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdio>

namespace dioptre
{

class EventLog
{
public:
    explicit EventLog(bool on) : on_(on) {}

    bool isOn() const
    {
        return on_;
    }

    // One line on standard output, at once.
    void say(const char* event, nlohmann::ordered_json details = nlohmann::ordered_json::object()) const
    {
        if (!on_)
            return;
        nlohmann::ordered_json line = {{"event", event}};
        line.update(details);
        std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        std::fflush(stdout);
    }

private:
    bool on_;
};

} // namespace dioptre
