#pragma once
#include <QTimer>

#include "app/document/document.h"
#include "app/talk/caption_line.h"
#include "app/talk/cue_model.h"

namespace app {

class AskPanel;

// The words at the bottom of a talk: of the cue, the question, the step or the stage. At the right, for a moment, the last
// key or what has failed; the list of errors is in the window behind.
class TalkCaption : public CaptionLine {
    Q_OBJECT
public:
    TalkCaption(Document& document, const CueModel& cues, const AskPanel& ask, QWidget* parent);

    void showKey(const QString& key);  // for 1.2 s

private:
    void showWords();
    void tell(const QString& failure);  // for 4 s
    void tellNotWritten(const QString& file);

    const Document& m_document;
    const CueModel& m_cues;
    const AskPanel& m_ask;
    QTimer m_keyTime;
};

}  // namespace app
