#include "app/buffer_view/buffer_selection.h"

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/frames/large_frame.h"

namespace app {

SelectionMark::SelectionMark(BufferView& view) : BufferFeature(view) {
    connect(&view.document().pointing(), &Pointing::selectionChanged, this, &SelectionMark::show);
    connect(&m_job, &BackgroundJob::busyChanged, this, &SelectionMark::busyChanged);
}

// The outline of an object of many polygons takes longer than a frame: the latest outline stays until then.
void SelectionMark::show() {
    const auto& selection = view().document().pointing().selection();
    const pipeline::FramePtr& frame = view().frame();
    const bool marks = frame && selection && view().isOfPixels();
    if (!marks || !isLarge(*frame)) {
        m_job.forget();
        return view().canvas()->setMarked(marks ? outlinesOf(*frame, *selection) : std::vector<QPolygonF>());
    }
    m_job.ask([frame, thing = *selection](const BackgroundJob::Control&) { return outlinesOf(*frame, thing); },
              [this](const std::vector<QPolygonF>& outlines) { view().canvas()->setMarked(outlines); },
              BackgroundJob::Running::Finish);
}

}  // namespace app
