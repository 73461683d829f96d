#include "live/painter.h"

namespace dioptre
{

Painter::RasterMake Painter::makeOf(const RasterScene& raster)
{
    RasterMake make;
    for (const auto& object : raster.prepared.packed.objects)
        make.kinds.insert(object.kind);
    make.shadowMap_px = raster.prepared.scene.raster.shadowMap_px;
    return make;
}

Painter::Painter(const Loaded& loaded, std::size_t place, const ContextInfo& context, Painter* before)
    : drawn_(loaded.drawn.at(place)), place_(place)
{
    if (loaded.plain) {
        plain_ = std::make_unique<PlainRenderer>(*loaded.plain, loaded.view, loaded.plainSettings);
        return;
    }
    scene_ = &*loaded.scene;
    if (const auto& raster = scene_->rasters.at(place)) {
        made_ = makeOf(raster->scene);
        raster_ = std::make_unique<RasterRenderer>(raster->scene, loaded.view, raster->texts);
        return;
    }
    Renderer* const same =
        before != nullptr && before->drawn_.pictures == drawn_.pictures ? before->traced_.get() : nullptr;
    traced_ = std::make_unique<Renderer>(scene_->prepared, loaded.view, context, scene_->parts, same);
}

Drawing& Painter::drawing() const
{
    if (plain_)
        return *plain_;
    return raster_ ? static_cast<Drawing&>(*raster_) : *traced_;
}

bool Painter::serves(const Loaded& loaded, std::size_t place) const
{
    const DrawnBy& next = loaded.drawn.at(place);
    if (next.method != drawn_.method || next.texts != drawn_.texts ||
        loaded.plain.has_value() != (plain_ != nullptr))
        return false;
    return !raster_ || makeOf(loaded.scene->rasters.at(place)->scene) == *made_;
}

void Painter::update(const Loaded& loaded, std::size_t place)
{
    const bool pictures = loaded.drawn.at(place).pictures != drawn_.pictures;
    if (plain_) {
        plain_->update(loaded.plainSettings.values);
        plain_->update(loaded.request.look.size_px);
        plain_->moveTo(loaded.plainSettings.frame);
        if (pictures)
            plain_->update(loaded.plain->channels);
    } else {
        scene_ = &*loaded.scene;
        place_ = place;
        if (pictures && raster_)
            raster_->updatePictures(scene_->rasters.at(place)->scene);
        else if (pictures)
            traced_->updatePictures(scene_->prepared);
        move(loaded.view);
    }
    drawn_ = loaded.drawn.at(place);
}

void Painter::move(const ViewSettings& view)
{
    if (raster_)
        raster_->update(scene_->rasters.at(place_)->scene, view);
    else if (traced_)
        traced_->update(scene_->prepared, view);
}

std::optional<RasterFacts> Painter::rasterFacts() const
{
    return raster_ ? std::optional(raster_->rasterFacts()) : std::nullopt;
}

void Painter::showWires(bool on)
{
    if (raster_)
        raster_->showWires(on);
}

} // namespace dioptre
