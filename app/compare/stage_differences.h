#pragma once
#include <QFrame>
#include <deque>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "pipeline/inspect/compare.h"

class QLabel;
class QTreeWidget;

namespace app {

class BufferCompare;

// Two pipelines in lock step: every buffer of every stage, how many of its elements differ and by how
// much at most. Choosing one goes to where it differs most. Opens over the view, closes by itself.
class StageDifferences : public QFrame {
    Q_OBJECT
public:
    StageDifferences(Document& document, BufferCompare& compare, QWidget* parent);

    void open(QPoint global);  // its upper right corner, where there is room
    const QTreeWidget& list() const { return *m_list; }

signals:
    void chosen(const pipeline::StageDifference& difference);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void start();
    void startFile(const pipeline::FramePtr& frame);
    void startMine(const pipeline::FramePtr& frame);
    void clear();
    void compareNext();
    void add(const pipeline::StageDifference& row);

    Document& m_document;
    BufferCompare& m_compare;
    QLabel* m_title;
    QTreeWidget* m_list;
    BackgroundJob m_job;
    pipeline::FramePtr m_a, m_b;
    std::shared_ptr<const void> m_file;        // or the report, that B was read from, as long as it is that
    std::deque<pipeline::BufferName> m_names;  // still to be compared
    std::vector<pipeline::StageDifference> m_rows;
};

}  // namespace app
