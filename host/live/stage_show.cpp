// How what was drawn is shown.
#include "live/divider.h"
#include "live/stage.h"

#include "render/still.h"

#include <algorithm>

namespace dioptre
{

void Stage::setDisplay(const std::optional<Display>& display)
{
    display_ = display;
    if (samplesDone_ > 0 && !isBegun())
        show();
}

void Stage::compare(const MethodChoice& choice)
{
    const bool wires = choice.wires != choice_.wires;
    const bool shows = choice.comparison != choice_.comparison || choice.scale != choice_.scale;
    choice_ = choice;
    if (choice_.comparison != Comparison::difference)
        difference_.reset();
    else if (!difference_)
        difference_ = std::make_unique<ShownPicture>(glslFolder_);
    if (wires && loaded_ != nullptr) {
        for (const Layer& layer : layers_)
            layer.painter->showWires(choice_.wires);
        begin();
    }
    if (shows && loaded_ != nullptr && samplesDone_ > 0 && !isBegun())
        show();
}

void Stage::show()
{
    const auto& first = layers_.front().painter->drawing().target();
    if (isPlain())
        return shown_.front()->take(first, 1, std::nullopt);
    const Display display = display_.value_or(loaded_->scene->prepared.scene.output);
    if (loaded_->view.view != DataView::none) {
        ShownView view = shownView(radiance(), loaded_->scene->prepared);
        shown_.front()->take(view.picture);
        facts_.legend = std::move(view.legend);
        return;
    }
    for (std::size_t i = 0; i < layers_.size(); ++i)
        shown_[i]->take(layers_[i].painter->drawing().target(), samplesDone_, display);
    if (difference_ && layers_.size() == drawnMethods(choice_).size())
        difference_->takeDifference(first, layers_.back().painter->drawing().target(), samplesDone_,
                                    choice_.scale, display);
}

Comparison Stage::comparison() const
{
    const bool all = loaded_ != nullptr && !isPlain() && layers_.size() == drawnMethods(choice_).size();
    const bool drawn = shown_.back()->size_px().x > 0 &&
                       (choice_.comparison != Comparison::difference || difference_->size_px().x > 0);
    return all && drawn ? choice_.comparison : Comparison::off;
}

void Stage::present(const glm::ivec2& window_px) const
{
    switch (comparison()) {
    case Comparison::difference:
        return difference_->draw(window_px);
    case Comparison::second:
        return shown_.back()->draw(window_px);
    case Comparison::split:
        shown_.front()->draw(window_px);
        return shown_.back()->drawFrom(dividerColumn_px(choice_.divider, window_px.x), window_px);
    default:
        return shown_.front()->draw(window_px);
    }
}

Picture Stage::read() const
{
    if (comparison() == Comparison::difference)
        return difference_->read();
    if (comparison() == Comparison::second)
        return shown_.back()->read();
    Picture picture = shown_.front()->read();
    if (comparison() != Comparison::split)
        return picture;
    const Picture right = shown_.back()->read();
    const auto column = static_cast<std::size_t>(dividerColumn_px(choice_.divider, picture.width));
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t texel = 0; texel < picture.bytes.size() / 4; ++texel)
        if (texel % width >= column && 4 * texel < right.bytes.size())
            std::copy_n(&right.bytes[4 * texel], 4, &picture.bytes[4 * texel]);
    return picture;
}

Picture Stage::radiance() const
{
    Picture picture = layers_.front().painter->drawing().read();
    if (isPlain())
        return picture;
    if (loaded_->view.view != DataView::none)
        dataFromSums(picture, loaded_->view.view, samplesDone_);
    meansOfSums(picture, samplesDone_);
    return picture;
}

} // namespace dioptre
