// A fixture for tests that read and write files.
#pragma once

#include "support/process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace dioptre::test
{

// Runs in a folder of its own, which the test removes.
class InAFolder : public testing::Test
{
protected:
    InAFolder()
    {
        std::string pattern = "/tmp/dioptre-test-" + std::string(6, 'X'); // mkdtemp replaces them
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        folder = pattern;
    }
    ~InAFolder() override
    {
        std::filesystem::remove_all(folder);
    }
    Outcome here(const std::string& command) const
    {
        return run("cd '" + folder.string() + "' && " + command);
    }

    std::filesystem::path folder;
};

} // namespace dioptre::test
