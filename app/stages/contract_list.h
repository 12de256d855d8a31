#pragma once
#include <QFrame>
#include <memory>

#include "app/document/document.h"
#include "app/document/renderer_check.h"
#include "app/jobs/background_job.h"
#include "pipeline/contracts/contract.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace app {

// The contracts of a stage's output: for each the share of elements that keep it, in this frame and in the compared
// renderer, if there is one. Violated contracts come first. The list opens below the stage's card.
class ContractList : public QFrame {
    Q_OBJECT
public:
    explicit ContractList(Document& document, QWidget* parent);

    void open(QPoint global, pipeline::StageId stage);
    pipeline::StageId stage() const { return m_stage; }
    const QTreeWidget& list() const { return *m_list; }
    bool busy() const { return m_job.busy(); }

signals:
    // The buffer in which violators can be seen; where the worst is, of pixels alone.
    void violatorsAsked(const pipeline::BufferName& buffer, std::optional<glm::ivec2> worst);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    struct Row {
        pipeline::ContractResult ours;
        std::optional<pipeline::ContractResult> mine;
        QString worst;  // of the one that is violated
        bool isViolated() const { return isBroken(ours) || (mine && isBroken(*mine)); }
        static bool isBroken(const pipeline::ContractResult& result) { return result.why.empty() && !result.holds(); }
    };
    using Rows = std::vector<Row>;
    static Rows evaluate(const pipeline::FramePtr& frame, const RendererCheck::ReportPtr& report,
                         pipeline::StageId stage, const std::stop_token& stop);
    void start();
    void take(std::shared_ptr<const Rows> rows);
    void showCurrent();
    void askForViolators();

    Document& m_document;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    QLabel *m_title, *m_worst;
    QTreeWidget* m_list;
    QPushButton* m_show;
    std::shared_ptr<const Rows> m_rows;
    pipeline::FramePtr m_frame;  // that they are of, or will be
    BackgroundJob m_job;
};

// "85.4 %"; "100 %" only where all hold, "–" where nothing was checked.
QString shareText(const pipeline::ContractResult& result);

}  // namespace app
