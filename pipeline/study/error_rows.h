#pragma once
#include <string_view>

#include "pipeline/study/errors.h"

// What the parts of compare() share.
namespace pipeline {

class ErrorRows {
public:
    // A row for each measure of a buffer; the same one for every kind of error.
    void put(const BufferName& buffer, std::string_view measure, std::string_view unit, ErrorKind kind, double value);
    std::vector<ErrorRow> take() { return std::move(m_rows); }

private:
    std::vector<ErrorRow> m_rows;
};

// The depth that is stored against z_view.
void addDepthStorage(const Frame& frame, const Picture& ours, ErrorRows& rows);
// The frame buffer against what it holds in steps of 255.
void addColorStorage(const Frame& frame, ErrorRows& rows);
// Against the intensities of a reference, brought to 255 steps; against another frame's.
void addColor(const Frame& frame, const Picture& reference, ErrorRows& rows);
void addColor(const Frame& frame, const Frame& reference, ErrorRows& rows);

// The numbers of a buffer, all at once.
std::vector<double> numbersOf(const AnyBuffer& buffer);
Vec3d vectorAt(const std::vector<double>& numbers, std::size_t i);

}  // namespace pipeline
