#include "stability/judge.h"

#include "base/statistics.h"
#include "stability/angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr double kMargin = 8.0;
constexpr double errorMargin = 64.0;
constexpr double unitRoundoff = 0x1p-24;

bool isFinite(const DeviceAnswer& answer)
{
    const glm::dvec3& n = answer.normal;
    return std::isfinite(answer.t) && std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z);
}

double perMillion(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : 1e6 * static_cast<double>(part) / static_cast<double>(whole);
}

// Takes in one ray that both hit.
void addHit(CaseFigures& figures, std::vector<double>& relative, const RayProblem& problem,
            const RayAnswer& truth, const DeviceAnswer& answer)
{
    const double off = std::abs(answer.t - truth.t);
    relative.push_back(off / truth.t);
    ++figures.judged;
    if (truth.margin > kMargin) {
        ++figures.judgedOver8;
        const double metres = off * glm::length(problem.direction) * truth.cosIncidence;
        figures.k = std::max(figures.k, metres / (unitRoundoff * extentOf(problem)));
    }
    if (truth.margin > errorMargin) {
        ++figures.judgedOver64;
        figures.relativeT = std::max(figures.relativeT, relative.back());
        figures.normal_rad = std::max(figures.normal_rad, angleBetween_rad(answer.normal, truth.normal));
    }
}

std::size_t countLeaks(std::size_t group, std::span<const RayAnswer> truth,
                       std::span<const DeviceAnswer> answers)
{
    std::size_t leaks = 0;
    for (std::size_t i = 0; i + group <= truth.size(); i += group) {
        const auto hits = [](const auto& answer) { return answer.hit; };
        const bool meant = std::ranges::any_of(truth.subspan(i, group), hits);
        leaks += meant && std::ranges::none_of(answers.subspan(i, group), hits) ? 1 : 0;
    }
    return leaks;
}

// Gathers breaches as a sentence.
class Breaches
{
public:
    void atMost(std::string_view what, double value, const std::optional<double>& most, bool known)
    {
        if (!most)
            return;
        if (!known)
            add(fmt::format("{} rests on no ray", what));
        else if (!(value <= *most))
            add(fmt::format("{} {:.3g} exceeds {:g}", what, value, *most));
    }

    void add(const std::string& breach)
    {
        text_ += (text_.empty() ? "" : "; ") + breach;
    }

    const std::string& text() const
    {
        return text_;
    }

private:
    std::string text_;
};

} // namespace

CaseFigures measureCase(const CaseRow& row, std::span<const RayProblem> problems,
                        std::span<const RayAnswer> truth, std::span<const DeviceAnswer> answers)
{
    CaseFigures figures;
    figures.rays = problems.size();
    std::vector<double> relative;
    std::size_t flips = 0;
    std::size_t flipsOverMargin = 0;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        if (!isFinite(answers[i]))
            ++figures.nonFinite;
        if (answers[i].hit != truth[i].hit) {
            ++flips;
            flipsOverMargin += truth[i].margin > kMargin ? 1 : 0;
        } else if (truth[i].hit && isFinite(answers[i])) {
            addHit(figures, relative, problems[i], truth[i], answers[i]);
        }
    }
    figures.relativeT_p999 = relative.empty() ? 0.0 : quantile(relative, 0.999);
    figures.flips = perMillion(flips, problems.size());
    figures.flipsOverMargin = perMillion(flipsOverMargin, problems.size());
    if (row.group > 1)
        figures.leaks = perMillion(countLeaks(row.group, truth, answers), problems.size() / row.group);
    return figures;
}

Verdict judgeCase(const CaseRow& row, const CaseFigures& figures)
{
    const Gate& gate = row.gate;
    Breaches breaches;
    if (figures.nonFinite > 0)
        breaches.add(fmt::format("{} answers hold a NaN or an infinity", figures.nonFinite));
    breaches.atMost("K", figures.k, gate.k, figures.judgedOver8 > 0);
    breaches.atMost("relative t", figures.relativeT, gate.relativeT, figures.judgedOver64 > 0);
    breaches.atMost("relative t at p99.9", figures.relativeT_p999, gate.relativeT_p999, figures.judged > 0);
    breaches.atMost("normal (rad)", figures.normal_rad, gate.normal_rad, figures.judgedOver64 > 0);
    const bool any = figures.rays > 0;
    breaches.atMost("flips per million", figures.flips, gate.flips, any);
    breaches.atMost("flips over margin per million", figures.flipsOverMargin, gate.flipsOverMargin, any);
    breaches.atMost("leaks per million", figures.leaks, gate.leaks, any);
    return {breaches.text().empty(), breaches.text()};
}

} // namespace dioptre
