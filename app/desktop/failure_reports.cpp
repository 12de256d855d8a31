#include "app/desktop/failure_reports.h"

#include "app/document/document.h"
#include "app/jobs/memory_notice.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/widgets/error_list.h"

namespace app {

void reportFailures(Document& document, ErrorList& errors) {
    QObject::connect(&document, &Document::failed, &errors, [&](const pipeline::Errors& found) {
        const QString file = found.empty() ? QString() : shownName(toQString(found.front().where.file));
        if (file.isEmpty()) return errors.report(Document::tr("That cannot be done. Nothing has changed."), found);
        const QString still = document.hasScene() ? Document::tr(" The scene before is still open.") : QString();
        errors.report(Document::tr("%1 could not be read.").arg(file) + still, found);
    });
    static constexpr const char* kLess = "not enough memory; a smaller picture and fewer buffers need less";
    QObject::connect(&document.frames(), &FrameFeed::outOfMemory, &errors, [&] {
        errors.report(Document::tr("There is not enough memory for this frame. What you see is the one before."),
                      {{{}, kLess, {}}});
    });
    QObject::connect(&MemoryNotice::instance(), &MemoryNotice::gaveUp, &errors, [&] {
        errors.report(Document::tr("There is not enough memory for all that is asked for. Something that you see is as "
                                   "it was."),
                      {{{}, kLess, {}}});
    });
    QObject::connect(&document, &Document::notWritten, &errors, [&](const QString& file, const pipeline::Errors& why) {
        errors.report(Document::tr("%1 could not be written. Nothing has changed.").arg(shownName(file)), why);
    });
}

}  // namespace app
