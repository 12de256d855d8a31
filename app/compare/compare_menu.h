#pragma once
#include "pipeline/buffers/buffer_table.h"

class QMenu;

namespace app {

class BufferCompare;
class Document;

// The menu of what a buffer can be compared with; shown: the buffer.
void fillCompareMenu(QMenu& menu, BufferCompare& compare, Document& document, const pipeline::BufferName& shown);

}  // namespace app
