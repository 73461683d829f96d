// One input at many times: context, programs and pictures are made once.
#pragma once

#include "command/command.h"
#include "command/input.h"
#include "render/plain.h"
#include "render/renderer.h"
#include "render/still.h"
#include "scene/load.h"

#include <memory>
#include <optional>

namespace dioptre
{

class FrameDrawer
{
public:
    // Of a scene everything is made that does not depend on the time. `first_s`: when the first frame is.
    FrameDrawer(const RenderOptions& options, const Input& input, double first_s);

    const ContextInfo& context() const
    {
        return context_;
    }
    // The scene at the time of the last frame; null for a plain shader.
    const PreparedScene* prepared() const
    {
        return prepared_ ? &*prepared_ : nullptr;
    }
    // What the making took, milliseconds.
    const Phases& made() const
    {
        return made_;
    }

    // `progress` is told the share that is drawn, 0..1.
    Still draw(double time_s, const std::function<void(double)>& progress);

    // A fingerprint of all that decides the pictures but the options and the time: the input's text, the
    // texts of the shaders, and the contents of the pictures that are read.
    unsigned long long sourcesFingerprint() const;

private:
    void addTimes(const BuildTimes& times);
    std::string plainSources() const;

    Input input_;
    StillSettings settings_;
    PlainSettings plain_; // of a plain shader
    std::string text_;    // of the input's file
    SceneOverTime scene_;
    std::optional<PreparedScene> prepared_;
    std::unique_ptr<Context> glContext_;
    ContextInfo context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<PlainRenderer> plainRenderer_;
    Phases made_;
};

} // namespace dioptre
