// The shadow maps of a scene on the device, drawn when something has moved.
#pragma once

#include "raster/mesh_buffer.h"
#include "raster/object_buffer.h"
#include "raster/raster_text.h"
#include "raster/sample_target.h"
#include "render/device_scene.h"

#include <optional>

namespace dioptre
{

// The views and the planes that shade, as the device holds them.
std::vector<float> numbersOf(const ShadowViews& shadows);

class ShadowPass
{
public:
    // Of a scene that has none it does nothing.
    ShadowPass() = default;
    // Throws badInput where the maps are too many or too large, and where `text` does not compile.
    ShadowPass(const RasterScene& raster, const RasterText& text);

    // Takes the views of the scene, which may have moved, to `device`. Its maps are drawn anew where the
    // lights see something else.
    void update(const RasterScene& raster, DeviceScene& device);

    // Takes away what update() added to `device`.
    static void release(DeviceScene& device);

    // Draws the maps where they are not as the scene is. Leaves another framebuffer bound.
    void draw(const RasterScene& raster, const DeviceScene& device, const ObjectBuffer& objects,
              const MeshBuffers& meshes);

    // Hands the maps to a program that is current, on the texture unit after those of bind().
    void bindTo(const Program& program, const RasterScene& raster, const DeviceScene& device) const;

    // The maps; null where there are none.
    const ShadowMaps* maps() const
    {
        return maps_ ? &*maps_ : nullptr;
    }

    // How often they were drawn.
    long draws() const
    {
        return draws_;
    }

private:
    void drawLayer(int layer, const std::vector<bool>& casting, const RasterScene& raster,
                   const ObjectBuffer& objects, const MeshBuffers& meshes) const;

    std::optional<ShadowMaps> maps_;
    Program caster_;
    std::vector<float> seen_; // by the lights, when the maps were drawn
    bool drawn_ = false;
    long draws_ = 0;
};

} // namespace dioptre
