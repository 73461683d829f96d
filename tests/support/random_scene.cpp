#include "support/random_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <random>
#include <vector>

namespace dioptre::test
{
namespace
{

class Dice
{
public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    double between(double low, double high)
    {
        // std::uniform_real_distribution may differ between libraries; this does not.
        return low + (high - low) * static_cast<double>(engine_() % 100003U) / 100003.0;
    }
    bool chance(double share)
    {
        return between(0.0, 1.0) < share;
    }
    std::size_t below(std::size_t count)
    {
        return engine_() % count;
    }
    std::string oneOf(std::initializer_list<const char*> words)
    {
        return *(words.begin() + below(words.size()));
    }
    std::string vector(double size)
    {
        return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", between(-size, size), between(-size, size),
                           between(-size, size));
    }
    std::string colour(double most = 1.0)
    {
        return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", between(0.0, most), between(0.0, most),
                           between(0.0, most));
    }

private:
    std::mt19937 engine_;
};

std::string sky(Dice& dice)
{
    switch (dice.below(3)) {
    case 0:
        return "[sky]\ncolour = " + dice.colour(2.0) + "\n";
    case 1:
        return fmt::format("[sky]\ngradient = [{}, {}, {}]\n", dice.colour(), dice.colour(), dice.colour());
    default:
        return fmt::format("[sky]\nimage = \"sky.exr\"\nrotation_deg = {:.1f}\nmirror_u = {}\n",
                           dice.between(-400.0, 400.0), dice.chance(0.3));
    }
}

std::string trace(Dice& dice)
{
    std::string text =
        "[trace]\norder = \"" + dice.oneOf({"heaviest-first", "breadth-first", "depth-first"}) + "\"\n";
    text += fmt::format("light_type = {}\n", dice.oneOf({"0", "1", "1", "1", "2"}));
    if (dice.chance(0.5))
        text += fmt::format("budget = {}\n", 1 + dice.below(24));
    if (dice.chance(0.2))
        text += fmt::format("depth = {}\n", dice.below(5));
    return text;
}

std::string material(Dice& dice, std::size_t index, bool glows)
{
    std::string text = fmt::format("[material.m{}]\ncolour = {}\n", index, dice.colour());
    if (dice.chance(0.3))
        text += "image = \"" + dice.oneOf({"wave.png", "floor.png"}) + "\"\n";
    if (dice.chance(0.3))
        text += fmt::format("pattern = \"checker\"\ncolours = [{}, {}]\nsize = {:.2f}\n", dice.colour(),
                            dice.colour(), dice.between(0.2, 2.0));
    const std::string model = dice.oneOf({"lambert", "phong", "blinn", "microfacet"});
    text +=
        "model = \"" + model + "\"\nspecular = " + (dice.chance(0.3) ? "[0, 0, 0]" : dice.colour()) + "\n";
    if (model == "microfacet")
        text += "roughness = " + dice.oneOf({"0.2", "0.5", "1.0"}) +
                "\nmetalness = " + dice.oneOf({"0.0", "0.6", "1.0"}) + "\n";
    if (dice.chance(0.3))
        text += "ambient = " + dice.colour() + "\n";
    if (dice.chance(0.4))
        text += "mirror = " + dice.oneOf({"0.2", "0.5", "1.0"}) + "\nmirror_colour = " + dice.colour() + "\n";
    if (dice.chance(0.5))
        text += "transmit = " + dice.oneOf({"0.5", "1.0"}) +
                "\nior = " + dice.oneOf({"1.0", "1.33", "1.5", "0.8"}) + "\n";
    if (dice.chance(0.3))
        text += "absorption = " + dice.colour() + "\n";
    if (glows)
        text += "emission = " + dice.colour(2.0) + "\nlight = true\n";
    if (index > 0 && dice.chance(0.3))
        text += fmt::format("outside = \"m{}\"\n", dice.below(index));
    if (dice.chance(0.3))
        text += "shadow = \"" + dice.oneOf({"opaque", "tinted", "none"}) + "\"\n";
    return text;
}

std::string light(Dice& dice)
{
    const auto kind = dice.oneOf({"ambient", "directional", "point", "spot"});
    std::string text = "[[light]]\nkind = \"" + kind +
                       "\"\nambient = " + (kind == "ambient" ? dice.colour() : dice.colour(0.2)) + "\n";
    if (kind == "point" || kind == "spot")
        text += "position = " + dice.vector(3.0) +
                "\nattenuation = " + dice.oneOf({"[1.0, 0.0, 0.0]", "[0.5, 0.0, 0.2]", "[1.0, 0.3, 0.0]"}) +
                "\n";
    if (kind == "directional" || kind == "spot")
        text += "direction = " + dice.vector(1.0) + "\n";
    if (kind == "spot")
        text += fmt::format("cutoff_deg = {:.1f}\nexponent = {}\n", dice.between(5.0, 90.0),
                            dice.oneOf({"0", "1.5", "20"}));
    return text;
}

std::string shape(Dice& dice, bool mustBeSphere)
{
    const auto size = [&dice](double low, double high) {
        return fmt::format("{:.3f}", dice.between(low, high));
    };
    switch (mustBeSphere ? 0 : dice.below(7)) {
    case 0:
        return "[[sphere]]\ncentre = " + dice.vector(1.5) + "\nradius = " + size(0.2, 1.2) + "\n";
    case 1:
        return "[[cylinder]]\nbase = " + dice.vector(1.5) + "\naxis = " + dice.vector(1.5) +
               "\nradius = " + size(0.1, 0.9) + "\n";
    case 2:
        return "[[cylinder]]\nbase = " + dice.vector(1.5) + "\naxis = " + dice.vector(1.5) +
               "\nradius = " + size(0.1, 0.9) + "\ncapped = true\n";
    case 3:
        return "[[plane]]\npoint = " + dice.vector(2.0) + "\nnormal = " + dice.vector(1.0) + "\n";
    case 4:
        return "[[disk]]\ncentre = " + dice.vector(1.5) + "\nnormal = " + dice.vector(1.0) +
               "\nradius = " + size(0.2, 1.2) + "\n";
    case 5:
        return "[[rectangle]]\ncorner = " + dice.vector(1.0) + "\nedge_u = " + dice.vector(1.5) +
               "\nedge_v = " + dice.vector(1.5) + "\n";
    default:
        return "[[triangle]]\na = " + dice.vector(1.5) + "\nb = " + dice.vector(1.5) +
               "\nc = " + dice.vector(1.5) + "\n";
    }
}

// The path to the first vector of a shape, of which `count` of its kind stand before it: "sphere.2.centre".
std::string placeOf(const std::string& shape, std::size_t count)
{
    const auto kind = shape.substr(2, shape.find(']') - 2);
    const auto key = shape.find('\n') + 1;
    return fmt::format("{}.{}.{}", kind, count, shape.substr(key, shape.find(' ', key) - key));
}

// Some of the shapes on the move, by dice of its own: the rest of a scene is as it is without.
std::string animations(unsigned seed, const std::vector<std::string>& shapes)
{
    Dice dice(seed + 1000000U);
    std::string text;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto kind = shapes[i].substr(0, shapes[i].find('\n'));
        const auto before = std::count_if(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(i),
                                          [&](const auto& shape) { return shape.starts_with(kind); });
        if (dice.chance(0.3))
            text += fmt::format("[[animate]]\npath = \"{}\"\ntimes = [0, 1]\nvalues = [{}, {}]\n",
                                placeOf(shapes[i], static_cast<std::size_t>(before)), dice.vector(1.5),
                                dice.vector(1.5));
    }
    return text;
}

} // namespace

std::string randomScene(unsigned seed)
{
    Dice dice(seed);
    const std::size_t materials = 1 + dice.below(4);
    std::string text = fmt::format("[camera]\neye = {}\ntarget = [0.0, 0.0, 0.0]\nfov_y_deg = {:.1f}\n",
                                   dice.vector(4.0), dice.between(20.0, 110.0));
    if (dice.chance(0.2))
        text += fmt::format("inside = \"m{}\"\n", dice.below(materials));
    text += sky(dice) + trace(dice);
    std::vector<bool> glows;
    for (std::size_t i = 0; i < materials; ++i) {
        glows.push_back(dice.chance(0.15));
        text += material(dice, i, glows.back());
    }
    for (std::size_t i = dice.below(4); i > 0; --i)
        text += light(dice);
    std::vector<std::string> shapes;
    for (std::size_t i = dice.below(6); i > 0; --i) {
        const auto chosen = dice.below(materials);
        shapes.push_back(shape(dice, glows[chosen]));
        text += shapes.back() + fmt::format("material = \"m{}\"\nrotate_texture_deg = {:.1f}\n", chosen,
                                            dice.between(-200.0, 200.0));
    }
    return text + animations(seed, shapes);
}

} // namespace dioptre::test
