#include "render/prepare.h"

#include "render/pack.h"

namespace dioptre
{
namespace
{

// A forced shader samples pictures that the scene does not have: one white texel changes nothing.
void addNeutralPictures(const Plan& plan, PackedScene& packed)
{
    const Picture white{1, 1, PixelFormat::srgb8, {255, 255, 255, 255}, {}};
    if (plan.has("picture") && packed.pictures.empty())
        packed.pictures.push_back({white});
    if (plan.has("sky picture") && packed.sky_picture.empty())
        packed.sky_picture.push_back(white);
}

std::vector<PicturePart> partsOf(const PreparedScene& prepared, const ViewSettings& view)
{
    if (cutsPicture(prepared.scene, prepared.plan,
                    static_cast<long>(view.width) * view.height * view.samples))
        return pictureParts(prepared.scene, prepared.plan, view.width, view.height);
    return {wholePicture(prepared.plan, view.width, view.height)};
}

// Where the picture cuts a path hangs on its brightest light: a view of the ray tree looks at that very tree.
void setCutOff(PreparedScene& prepared, const Scene& scene, const ViewSettings& view)
{
    if (!showsRayTree(view.view))
        return setCutOff(prepared.scene, prepared.plan, prepared.packed);
    if (view.view == DataView::trust && scene.trace.cutOff <= packed::TRUSTED_WEIGHT) {
        prepared.packed.cutOff = packed::TRUSTED_WEIGHT; // lighter paths do not count
        return;
    }
    const Scene lit = underLightType(scene);
    const Plan plan = makePlan(lit);
    PackedScene packed = pack(lit, plan, View{view.height, view.samples});
    packed.skyPictureBrightness = prepared.packed.skyPictureBrightness;
    if (!packed.skyPictureBrightness)
        loadSkyPicture(lit, plan, packed, view.pictures);
    setCutOff(lit, plan, packed);
    prepared.packed.skyPictureBrightness = packed.skyPictureBrightness;
    prepared.packed.cutOff = packed.cutOff;
}

} // namespace

PreparedScene prepare(const Scene& scene, const ViewSettings& view, const PictureSource& pictures)
{
    PreparedScene prepared;
    prepared.scene = underView(underLightType(scene), view.view);
    prepared.plan = makePlan(prepared.scene, view.view);
    prepared.packed = pack(prepared.scene, prepared.plan, View{view.height, view.samples});
    if (pictures)
        pictures(prepared.scene, prepared.plan, prepared.packed);
    else
        loadPictures(prepared.scene, prepared.plan, prepared.packed, view.pictures);
    setCutOff(prepared, scene, view);
    addNeutralPictures(prepared.plan, prepared.packed);
    prepared.parts = partsOf(prepared, view);
    return prepared;
}

void moveTo(PreparedScene& prepared, const Scene& scene, const ViewSettings& view)
{
    prepared.scene = underView(underLightType(scene), view.view);
    PackedScene packed = pack(prepared.scene, prepared.plan, View{view.height, view.samples});
    packed.pictures = std::move(prepared.packed.pictures);
    packed.sky_picture = std::move(prepared.packed.sky_picture);
    packed.skyPictureBrightness = prepared.packed.skyPictureBrightness;
    prepared.packed = std::move(packed);
    setCutOff(prepared, scene, view);
}

} // namespace dioptre
