// What is told of how far a picture in single precision means anything.
#pragma once

#include "command/command.h"
#include "command/picture_drawer.h"

#include <optional>
#include <string_view>

namespace dioptre
{

class TrustAccount
{
public:
    explicit TrustAccount(const RenderOptions& options);

    // shareBeyondTrust() of the scene as it is to be drawn. None of a view, of a plain shader, where the
    // reference draws, and where the tracer was edited since the account was compiled from it.
    std::optional<double> operator()(const PictureDrawer& drawer) const;

private:
    double width_, height_;
    bool speaks_;
};

// On standard error, where the share is over 1 %; `picture` as in "of the picture".
void warnOfTrust(double share, std::string_view picture);

} // namespace dioptre
