// What draws a scene by one method, or a plain shader, on the device.
#pragma once

#include "live/loaded.h"
#include "raster/raster_renderer.h"
#include "render/renderer.h"

#include <memory>
#include <optional>
#include <set>

namespace dioptre
{

class Painter
{
public:
    // By the method of that place in what is loaded, which must outlive it. `before` gives its textures away
    // where it draws the very same pictures by the same method; null for none. Throws badInput where programs
    // cannot be made.
    Painter(const Loaded& loaded, std::size_t place, const ContextInfo& context, Painter* before);

    // Whether it can go on with what is loaded, which has other values at most.
    bool serves(const Loaded& loaded, std::size_t place) const;

    // Goes on so.
    void update(const Loaded& loaded, std::size_t place);

    // After what is loaded was moved: to another time, camera or size.
    void move(const ViewSettings& view);

    Drawing& drawing() const;
    // Of a plain shader; null for a scene.
    PlainRenderer* plain() const
    {
        return plain_.get();
    }
    const Method& method() const
    {
        return drawn_.method;
    }

    // Of the picture as it is now; nothing where it is traced.
    std::optional<RasterFacts> rasterFacts() const;

    // Facets' edges over the picture; nothing where it is traced.
    void showWires(bool on);

private:
    // What a rasterised scene's buffers and maps are made for.
    struct RasterMake {
        std::set<int> kinds; // of objects
        int shadowMap_px = 0;
        bool operator==(const RasterMake&) const = default;
    };
    static RasterMake makeOf(const RasterScene& raster);

    DrawnBy drawn_;
    std::optional<RasterMake> made_; // where it rasterises
    const LoadedScene* scene_ = nullptr;
    std::size_t place_ = 0;
    std::unique_ptr<Renderer> traced_;
    std::unique_ptr<RasterRenderer> raster_;
    std::unique_ptr<PlainRenderer> plain_;
};

} // namespace dioptre
