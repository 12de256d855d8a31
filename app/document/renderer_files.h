#pragma once
#include <QString>
#include <QStringList>
#include <optional>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/compare/verdict.h"

// What the window makes of another renderer's files, beside what pipeline/compare says of them.
namespace app {

// Names, sizes and times of the files in folders, and of files by themselves: another text where one has changed.
QString stampOf(const QStringList& paths);

// A buffer that was handed in, in the type of `like`, this program's of the same name; nothing where it was not handed in.
std::optional<pipeline::AnyBuffer> handedBuffer(const pipeline::foreign::Report& report,
                                                const pipeline::AnyBuffer& like);

}  // namespace app
