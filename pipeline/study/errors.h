#pragma once
#include <optional>
#include <vector>

#include "pipeline/run/frame.h"
#include "pipeline/study/picture.h"
#include "pipeline/study/study.h"

namespace pipeline {

// How far a frame's buffers are off what they should be. Two pictures are compared where both see the same object, two
// frames where they see the same polygon; object_id and polygon_id count the other pixels. Where there is no such pixel
// nothing was measured, and there is no row. Coverage and the 8-bit colours are those of the whole picture.

// What a frame must be asked for to become a picture; and beside that, to be compared.
BufferSet picturesNeed();
BufferSet errorsNeed();

// A frame as it is, in double. Buffers that it does not hold stay empty.
Picture pictureOf(const Frame& frame);

// I_max: the intensity that 255 stands for. Errors of intensities are in shares of it, but for those named relative.
double whiteOf(const Scene& scene);

// What a frame is compared with; null where there is no such reference.
struct ErrorReferences {
    const Picture* model = nullptr;     // the true surfaces
    const Frame* arithmetic = nullptr;  // the same scene in a wider arithmetic
};

// Whether an arithmetic is wider than the double that buffers are read in: their differences may vanish in rounding.
constexpr bool isWiderThanDouble(Precision precision) {
    return precision == Precision::Extended || precision == Precision::Quad;
}

// One row a measure, in the order of the stages; storage errors need no reference. Of arithmetic wider than double a
// buffer that differs from the reference by rounding alone has no arithmetic error: it cannot be measured. Buffers that are not there have no
// rows. ours: pictureOf(frame).
//   object_id         pixels that differ; of those falsely drawn, missing, and showing another object; and by the
//                     reference's outline, pixel sides between two objects
//   polygon_id        pixels that differ, arithmetic only: another object's polygon, or another one of the same object
//   z_view            RMSE, largest, largest relative
//   depth             what is stored against z_view: in steps of the format where z_view lies, and decoded
//   vertices.screen   largest distance in the picture
//   polygons.verdict  polygons that differ
//   normals           angles between, and how many are not of unit length within 4 rounding units
//   shadow_buffer.k   largest difference of a depth, relative to the largest
//   shadow.k          the mean of |S − S_ref|: the share misclassified where S is 0 or 1; and its two parts
//   intensity         RMSE, 99 %, largest, and relative |ΔI| / (I_ref + 0.01 I_max) as tev has it
//   antialiased       RMSE and largest over the whole picture, where the reference has it; of a frame with one sample a
//                     pixel that sample counts as the mean
//   color             pixels that differ, largest step, PSNR, none for equal pictures, and mean SSIM (Z. Wang et al.,
//                     "Image quality assessment", IEEE TIP 2004; luma, windows of 8 x 8); storage: what rounding to 255
//                     steps lost of the linear intensity
std::vector<ErrorRow> compare(const Frame& frame, const Picture& ours, const ErrorReferences& references);

// The same measures between two pictures of a scene, as errors of the model: how far one may itself be wrong. Without
// those that count pixels.
std::vector<ErrorRow> comparePictures(const Scene& scene, const Picture& ours, const Picture& reference);

// Whether the picture shows any object.
bool showsAnything(const Picture& picture);

// The row that counts the pixels which this error leaves out, as they do not show what the reference shows; nothing for
// an error that leaves out none.
std::optional<ErrorChoice> leftOutOf(const ErrorChoice& choice);

// The errors of a buffer that compare() may find in some scene, as a plot shows them: without PSNR and mean SSIM, of
// which more is better.
std::vector<ErrorChoice> knownErrors(const BufferName& buffer);

// ours − reference of the intensity at every pixel, in shares of white (I_max); what is not seen is black.
Buffer2D<Vec3d> signedError(const Picture& ours, const Picture& reference, double white);

// Of one value a place.
struct ErrorSpread {
    double mean = 0, rmse = 0, p99 = 0, largest = 0;  // p99: nearest rank
};
// sizes: of the errors, >= 0. All 0 for none.
ErrorSpread spreadOf(std::vector<double> sizes);

}  // namespace pipeline
