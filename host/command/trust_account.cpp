#include "command/trust_account.h"

#include "kernel/reference.h"
#include "kernel/trust.h"

#include <fmt/format.h>

#include <cstdio>

namespace dioptre
{

TrustAccount::TrustAccount(const RenderOptions& options)
    : width_(options.width), height_(options.height),
      speaks_(!options.reference && !isRasterised(methodNamed(options.method)) &&
              shaderFingerprint(glslFolder()) == compiledShaderFingerprint())
{
}

std::optional<double> TrustAccount::operator()(const PictureDrawer& drawer) const
{
    const PreparedScene* prepared = drawer.prepared();
    if (!speaks_ || prepared == nullptr || prepared->plan.view != DataView::none)
        return std::nullopt;
    return shareBeyondTrust(prepared->packed, width_, height_);
}

void warnOfTrust(double share, std::string_view picture)
{
    constexpr double most = 0.01;
    if (share > most)
        fmt::print(
            stderr,
            "dioptre: {:.1f} % of {} is beyond what single precision can tell: --view trust shows where, "
            "--reference draws in double precision\n",
            100.0 * share, picture);
}

} // namespace dioptre
