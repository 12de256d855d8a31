#pragma once
#include <QObject>
#include <memory>

#include "app/document/renderer_check.h"

namespace app {

class Document;

// What a comparison with somebody else's renderer has found, without a widget: the report, with no more given away than
// the hints say, and the way to where the two differ.
class RendererFinding : public QObject {
    Q_OBJECT
public:
    explicit RendererFinding(Document& document, QObject* parent = nullptr);

    Document& document() const { return m_document; }
    RendererCheck& check() const;
    const RendererCheck::ReportPtr& report() const { return m_report; }  // the latest; null if there is none
    int hints() const { return m_hints; }
    static int keptHints();
    void setHints(int hints);  // 0 to 3, kept in the program's settings
    void giveNextHint();       // once

    bool canGoToWorst() const;
    void goToWorst();  // of the pixels that differ; again: the next one
    void goToStage(pipeline::StageId stage);
    QString text() const;  // as the command prints it
    void copy();

signals:
    void changed();
    void begun();                                        // the first report of a folder: views can be set to it
    void showAsked(const pipeline::BufferName& buffer);  // with mine as B

private:
    void take();

    Document& m_document;
    RendererCheck::ReportPtr m_report;
    int m_hints = 3;
    bool m_begins = false;  // the next report is the first of its folder
    std::vector<glm::ivec2> m_worst;
    std::size_t m_nextWorst = 0;
};

}  // namespace app
