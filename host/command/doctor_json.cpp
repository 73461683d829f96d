#include "command/doctor.h"
#include "command/json_text.h"
#include "render/samples.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace dioptre
{
namespace
{

using Json = nlohmann::ordered_json;

Json jsonOf(const Attempt& attempt)
{
    if (!attempt.fault.empty())
        return {{"backend", attempt.info.backend},
                {"works", false},
                {"ended_process", attempt.endedProcess},
                {"absent", attempt.absent},
                {"fault", attempt.fault}};
    return {{"backend", attempt.info.backend},   {"works", true},
            {"renderer", attempt.info.renderer}, {"version", attempt.info.version},
            {"glsl", attempt.info.glslVersion},  {"context_ms", attempt.start_ms}};
}

Json jsonOf(const DeviceLimits& limits)
{
    return {{"texture_side_px", limits.textureSide_px},
            {"viewport_px", {limits.viewportWidth_px, limits.viewportHeight_px}},
            {"array_layers", limits.arrayLayers},
            {"uniform_block_bytes", limits.uniformBlock_bytes},
            {"fragment_uniform_blocks", limits.fragmentUniformBlocks},
            {"fragment_uniform_components", limits.fragmentUniformComponents},
            {"fragment_texture_units", limits.fragmentTextureUnits},
            {"float_target", limits.drawsIntoFloat},
            {"gpu_shader5", limits.gpuShader5}};
}

Json jsonOf(const LoopCanary& loops, bool software)
{
    return {{"asked", loops.asked},
            {"ran", loops.ran},
            {"cap", loops.capped() ? Json(loops.ran) : Json()},
            {"of_two", {{"asked", loops.askedOfTwo}, {"ran", loops.ranOfTwo}}},
            {"of_neighbours", {{"asked", loops.askedOfNeighbours}, {"least_ran", loops.ranOfNeighbours}}},
            {"faithful", loops.faithful},
            {"iterations_per_draw", iterationsPerDraw},
            {"most_per_sample", software ? Json(softwareLoopCap) : Json()}};
}

Json jsonOf(const Tally& tally)
{
    return tally.tested == 0 ? Json() : Json{{"tested", tally.tested}, {"wrong", tally.wrong}};
}

// JSON has no infinity and no NaN: they stand as the strings "inf", "-inf", "nan".
Json jsonOf(float number)
{
    return std::isfinite(number) ? Json(number) : Json(fmt::format("{}", number));
}

const char* nameOf(Guard guard)
{
    switch (guard) {
    case Guard::precise:
        return "precise";
    case Guard::unit:
        return "uniform";
    case Guard::none:
        break;
    }
    return "none";
}

Json jsonOf(const ExactArithmetic& arithmetic)
{
    const auto [plain, precise, unit, fma, extremes] = arithmetic;
    return {{"two_sum",
             {{"plain", jsonOf(plain.twoSum)},
              {"precise", jsonOf(precise.twoSum)},
              {"uniform", jsonOf(unit.twoSum)}}},
            {"two_product",
             {{"plain", jsonOf(plain.twoProduct)},
              {"precise", jsonOf(precise.twoProduct)},
              {"uniform", jsonOf(unit.twoProduct)},
              {"fma", jsonOf(fma)}}},
            {"guard", nameOf(guardOf(arithmetic))},
            {"normalize_1e20", jsonOf(extremes.normalizeLarge)},
            {"normalize_1e-20", jsonOf(extremes.normalizeSmall)},
            {"atan_0_0", jsonOf(extremes.atanOfZeros)},
            {"pow_0_0", jsonOf(extremes.powOfZeros)},
            {"subnormal_results", extremes.subnormalResults},
            {"subnormal_operands", extremes.subnormalOperands}};
}

Json jsonOf(const DriverEnvironment& environment)
{
    return {{"shader_cache", environment.shaderCache},
            {"shader_cache_reason", environment.cacheReason},
            {"raster_threads", environment.rasterThreads},
            {"lp_num_threads", environment.threadsAsked.empty() ? Json() : Json(environment.threadsAsked)},
            {"cores", environment.cores}};
}

} // namespace

std::string doctorJson(const std::vector<Attempt>& attempts, const DeviceFindings* findings,
                       const Verdict& verdict)
{
    Json json{{"backends", Json::array()}};
    for (const Attempt& attempt : attempts)
        json["backends"].push_back(jsonOf(attempt));
    if (findings != nullptr) {
        const ContextInfo& context = findings->context;
        json["backend"] = context.backend;
        json["renderer"] = context.renderer;
        json["software"] = context.software;
        json["limits"] = jsonOf(findings->limits);
        json["environment"] = jsonOf(findings->environment);
    }
    if (findings != nullptr && findings->limits.drawsIntoFloat) {
        const Clocks& clocks = findings->clocks;
        const bool software = findings->context.software;
        json["float_sums"] = {{"right", findings->sums.right}, {"worst_ulp", findings->sums.worst_ulp}};
        json["clock"] = {{"use", nameOf(findings->clock)},
                         {"finish_ms", clocks.finish_ms},
                         {"timer_query_ms", clocks.timerQuery_ms}};
        json["loops"] = jsonOf(findings->loops, software);
        json["arithmetic"] = jsonOf(findings->arithmetic);
    }
    json["verdict"] = {{"exit_code", static_cast<int>(verdict.code)}, {"text", verdict.text}};
    return jsonText(json);
}

} // namespace dioptre
