#include "app/look/luminance.h"

#include <array>

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferInfo;
using pipeline::Palette;

namespace {

struct Made {
    BufferInfo info;
    std::vector<double> numbers;
};

}  // namespace

bool hasLuminance(const BufferInfo& info) {
    return info.palette == Palette::Color && info.channels == 3 && info.id != pipeline::BufferId::Barycentric;
}

AnyBuffer luminanceOf(const AnyBuffer& color) {
    const auto made = std::make_shared<Made>();
    made->info = *color.info;
    made->info.element = pipeline::Element::Real;
    made->info.channels = 1;
    made->info.palette = Palette::Sequential;
    made->info.meaning = "Luminance, Rec. 709.";
    std::array<double, 256> light;
    for (std::size_t byte = 0; byte < light.size(); ++byte) light[byte] = linearLight(int(byte));
    std::visit(
        [&]<class T>(std::span<const T> numbers) {
            const auto linear = [&](T value) {
                if constexpr (std::is_same_v<T, std::uint8_t>)
                    return light[value];
                else
                    return double(value);
            };
            made->numbers.reserve(numbers.size() / 3);
            for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
                made->numbers.push_back(luminance(linear(numbers[i]), linear(numbers[i + 1]), linear(numbers[i + 2])));
        },
        color.data);
    std::vector<std::size_t> shape = color.shape;
    shape.pop_back();
    return {color.name, &made->info, std::move(shape), std::span<const double>(made->numbers), made};
}

}  // namespace app
