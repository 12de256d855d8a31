#pragma once
#include <vector>

#include "pipeline/buffers/buffer_table.h"

namespace app {

class BufferView;
class Document;
class ViewGrid;

// The buffers of the current stage in the views: going to a stage shows its main buffer in the first buffer view, and the
// buffers that explain it in the others of a named arrangement. In an arrangement that the user has made the others keep
// theirs.
class StageInViews {
public:
    StageInViews(const Document& document, const ViewGrid& grid) : m_document(document), m_grid(grid) {}

    void showStage();
    void followStepper();                      // going inside a stage, or out again, shows buffers that are there
    void begin(BufferView& view) const;        // a new view: a buffer of the stage by its number of views
    void showAnother(BufferView& view) const;  // the first buffer of the stage that no view of the tree shows

private:
    void showInside();
    std::vector<pipeline::BufferName> useful(bool inside) const;

    const Document& m_document;
    const ViewGrid& m_grid;
    bool m_inside = false;  // the stepper, when last looked at
};

}  // namespace app
