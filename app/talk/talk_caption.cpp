#include "app/talk/talk_caption.h"

#include "app/jobs/memory_notice.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/talk/ask_panel.h"

namespace app {
namespace {

constexpr int kKeyMs = 1200, kFailedMs = 4000;

}  // namespace

TalkCaption::TalkCaption(Document& document, const CueModel& cues, const AskPanel& ask, QWidget* parent)
    : CaptionLine(parent), m_document(document), m_cues(cues), m_ask(ask) {
    m_keyTime.setSingleShot(true);
    connect(&m_keyTime, &QTimer::timeout, this, [this] { setKey({}); });
    connect(&document, &Document::stageChanged, this, &TalkCaption::showWords);
    connect(&document.stepper(), &Stepper::changed, this, &TalkCaption::showWords);
    connect(&cues, &CueModel::changed, this, &TalkCaption::showWords);
    connect(&ask, &AskPanel::changed, this, &TalkCaption::showWords);
    connect(&document, &Document::failed, this, [this](const pipeline::Errors& errors) {
        if (errors.empty()) return;
        const QString file = shownName(toQString(errors.front().where.file));
        tell(file.isEmpty() ? toQString(errors.front().found) : tr("%1 could not be read").arg(file));
    });
    connect(&document.frames(), &FrameFeed::outOfMemory, this,
            [this] { tell(tr("not enough memory for this frame")); });
    connect(&MemoryNotice::instance(), &MemoryNotice::gaveUp, this, [this] { tell(tr("not enough memory")); });
    connect(&document, &Document::notWritten, this, &TalkCaption::tellNotWritten);
    connect(&cues, &CueModel::notWritten, this, &TalkCaption::tellNotWritten);
    showWords();
}

void TalkCaption::showKey(const QString& key) {
    setKey(key);
    m_keyTime.start(kKeyMs);
}

void TalkCaption::tell(const QString& failure) {
    setKey(failure);
    m_keyTime.start(kFailedMs);
}

void TalkCaption::tellNotWritten(const QString& file) { tell(tr("%1 could not be written").arg(shownName(file))); }

void TalkCaption::showWords() {
    const auto& stage = stageInfo(m_document.stage());
    const lessons::Cue* cue = m_cues.currentCue();
    QString sentence = cue ? toQString(cue->caption.empty() ? cue->name : cue->caption) : toQString(stage.summary);
    if (m_ask.asks()) sentence = m_ask.remark();
    const Stepper& stepper = m_document.stepper();
    const bool moved = cue && stepper.place() != cue->state.place;
    if (stepper.isInside() && (!cue || moved)) sentence = stepper.words();
    // A cue that was never named is called after its stage.
    const QString label = toQString(stage.label);
    setText(sentence.startsWith(label) ? QString() : label, sentence);
    setCues(m_cues.size(), m_cues.current());
}

}  // namespace app
