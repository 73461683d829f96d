#include "render/prepare.h"

#include "render/pack.h"

namespace dioptre
{

PreparedScene prepare(const Scene& scene, const ViewSettings& view)
{
    PreparedScene prepared;
    prepared.scene = underLightType(scene);
    prepared.plan = makePlan(prepared.scene);
    prepared.packed = pack(prepared.scene, prepared.plan, View{view.height, view.samples});
    loadPictures(prepared.scene, prepared.plan, prepared.packed);
    setCutOff(prepared.scene, prepared.plan, prepared.packed);
    return prepared;
}

} // namespace dioptre
