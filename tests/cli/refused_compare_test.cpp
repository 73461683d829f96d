// Refusals of `dioptre compare`.
#include "support/refusal.h"

using namespace dioptre::test;

namespace
{

const std::string twoPictures = "cp \"$SOURCES/tests/golden/glass.png\" a.png; cp a.png b.png";

const std::vector<Case> compareCases = {
    {"OfOtherSizes",
     twoPictures + "; cp \"$SOURCES/textures/gallery/glass.png\" b.png",
     "dioptre compare a.png b.png -o d.png",
     65,
     {"b.png: is ", "and a.png is ", "compare pictures of one size"}},
    {"AMissingReference",
     twoPictures,
     "dioptre compare absent.png b.png",
     66,
     {"absent.png: cannot be read"}},
    {"AMissingPicture", twoPictures, "dioptre compare a.png absent.exr", 66, {"absent.exr: cannot be read"}},
    {"AFolder", twoPictures, "dioptre compare . b.png", 66, {".: is a folder"}},
    {"NoPicture",
     twoPictures + "; echo text >b.png",
     "dioptre compare a.png b.png",
     65,
     {"b.png: is not a pict"}},
    {"AnEmptyFile", twoPictures + "; : >b.png", "dioptre compare a.png b.png", 65, {"b.png: is empty"}},
    {"ACutFile",
     twoPictures + "; head -c 2000 a.png >b.png",
     "dioptre compare a.png b.png -o d.png",
     65,
     {"b.png: is broken or cut short"}},
    {"AnOutputOfAnUnknownKind",
     twoPictures,
     "dioptre compare a.png b.png -o d.gif",
     2,
     {"none of .png, .hdr"}},
    {"AnOutputOverAnInput",
     twoPictures,
     "dioptre compare a.png b.png -o ./b.png",
     2,
     {"one of the pictures"}},
    {"AnOutputInNoFolder",
     twoPictures,
     "dioptre compare a.png b.png -o no/d.png",
     73,
     {"there is no folder no"}},
    {"OnePicture", twoPictures, "dioptre compare a.png", 2, {"name a second picture"}},
    {"ExposureOfPngs",
     twoPictures,
     "dioptre compare a.png b.png --exposure 1",
     2,
     {"--exposure is for radiance"}},
    {"CurveOfPngs",
     twoPictures,
     "dioptre compare a.png b.png --curve filmic",
     2,
     {"--curve is for radiance"}},
    {"ExposureOutOfReach", twoPictures, "dioptre compare a.png b.png --exposure nan", 2, {"--exposure nan"}},
    {"UnknownCurve", twoPictures, "dioptre compare a.png b.png --curve s", 2, {"--curve", "reinhard"}},
    {"NoPixelsPerDegree", twoPictures, "dioptre compare a.png b.png --ppd 0", 2, {"--ppd"}},
    {"PixelsPerDegreeThatAreNoNumber", twoPictures, "dioptre compare a.png b.png --ppd nan", 2, {"--ppd"}},
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Compare, Refusal, testing::ValuesIn(compareCases), nameOf);
