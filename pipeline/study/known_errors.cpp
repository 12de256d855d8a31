#include <array>

#include "pipeline/study/errors.h"

namespace pipeline {
namespace {

using enum BufferId;

struct KnownError {
    BufferId buffer;
    std::string_view measure;
    std::array<bool, kErrorKinds> kinds;  // model, arithmetic, storage
};

constexpr std::array<bool, kErrorKinds> kPictures{true, true, false}, kArithmetic{false, true, false},
    kStorage{false, false, true}, kColors{true, true, true};

// errors.cpp and error_storage.cpp make them; a test compares.
constexpr auto kKnown = std::to_array<KnownError>({
    {VerticesScreen, "largest", kArithmetic},
    {PolygonsVerdict, "polygons that differ", kArithmetic},
    {PolygonsNormal, "mean angle", kArithmetic},
    {PolygonsNormal, "99 % angle", kArithmetic},
    {PolygonsNormal, "largest angle", kArithmetic},
    {PolygonsNormal, "not of unit length", kArithmetic},
    {VerticesNormal, "mean angle", kArithmetic},
    {VerticesNormal, "99 % angle", kArithmetic},
    {VerticesNormal, "largest angle", kArithmetic},
    {VerticesNormal, "not of unit length", kArithmetic},
    {ShadowBuffer, "largest relative", kArithmetic},
    {Depth, "largest in steps", kStorage},
    {Depth, "RMSE", kStorage},
    {Depth, "largest", kStorage},
    {ZView, "RMSE", kPictures},
    {ZView, "largest", kPictures},
    {ZView, "largest relative", kPictures},
    {ObjectId, "pixels that differ", kPictures},
    {ObjectId, "falsely drawn", kPictures},
    {ObjectId, "missing", kPictures},
    {ObjectId, "another object", kPictures},
    {ObjectId, "by outline", kPictures},
    {PolygonId, "pixels that differ", kArithmetic},
    {Normal, "mean angle", kPictures},
    {Normal, "99 % angle", kPictures},
    {Normal, "largest angle", kPictures},
    {Normal, "not of unit length", kArithmetic},
    {Shadow, "misclassified", kPictures},
    {Shadow, "false shadow", kPictures},
    {Shadow, "leak", kPictures},
    {Shadow, "largest", kPictures},
    {Intensity, "RMSE", kPictures},
    {Intensity, "99 %", kPictures},
    {Intensity, "largest", kPictures},
    {Intensity, "largest relative", kPictures},
    {Antialiased, "RMSE", kPictures},
    {Antialiased, "largest", kPictures},
    {Color, "pixels that differ", kPictures},
    {Color, "RMSE", kColors},
    {Color, "largest step", kColors},
});

}  // namespace

std::optional<ErrorChoice> leftOutOf(const ErrorChoice& choice) {
    const auto buffer = findBuffer(choice.buffer);
    const bool ofSamePixels =
        buffer && (buffer->id == ZView || buffer->id == Normal || buffer->id == Shadow || buffer->id == Intensity);
    if (!ofSamePixels || choice.kind == ErrorKind::Storage || choice.measure == "not of unit length") return {};
    const BufferId ids = choice.kind == ErrorKind::Arithmetic ? PolygonId : ObjectId;
    return ErrorChoice{BufferName{ids}.text(), "pixels that differ", choice.kind};
}

std::vector<ErrorChoice> knownErrors(const BufferName& buffer) {
    std::vector<ErrorChoice> choices;
    for (const KnownError& known : kKnown)
        for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
            if (known.buffer == buffer.id && known.kinds[kind])
                choices.push_back({buffer.text(), std::string(known.measure), static_cast<ErrorKind>(kind)});
    return choices;
}

}  // namespace pipeline
