// Build step: the fingerprint of the shader sources that the reference is compiled from, as a C++ header.
#include "kernel/reference.h"

#include <cstdio>

int main(int count, char** arguments)
{
    if (count != 2)
        return 2;
    std::printf("constexpr unsigned long long compiledFingerprint = %lluULL;\n",
                dioptre::shaderFingerprint(arguments[1]));
}
